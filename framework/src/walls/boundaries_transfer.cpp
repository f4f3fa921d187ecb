#include "walls/boundaries.hpp"
#include "walls/plane_transfer.hpp"

#include <string>
#include <utility>

#include <scree/state_transfer.hpp>

namespace scree {

void Boundaries::transfer(const StateTransfer& state, bool extrapolated) {
  for (std::size_t k = 0; k < members_.size(); ++k) {
    Member& member = members_[k];
    const StateTransfer of_member = state.below(std::to_string(k));
    std::uint64_t first_plane = member.first_plane, planes = member.plugin.instance().plane_count;
    of_member.value("first_plane", "", first_plane);
    of_member.value("plane_count", "1", planes);
    if (first_plane != member.first_plane || planes != member.plugin.instance().plane_count)
      of_member.refuse("plane_count", "or 'first_plane' is not that of the boundary here");
    member.clock.transfer(of_member);
    if (state.restoring() && member.clock.shows_others()) configure_by_clock(member);
    of_member.sized_rows("state", "1", member.state, 1, stored::any);
    of_member.value("kinetic", "J", member.energy.kinetic, stored::any);
    of_member.value("work", "J", member.energy.work, stored::any);
    of_member.value("dissipated", "J", member.energy.dissipated, stored::any);
  }
  transfer_planes(state.below("planes"), planes_);
  double* const force = loads_.empty() ? nullptr : loads_[0].force;
  state.vectors("load", "N", {force, 3, loads_.size(), 0, 3}, 0, 3);
  Vec3 lower = domain_.lower, upper = domain_.upper;
  state.numbers("domain_lower", "m", lower.component, 3);
  state.numbers("domain_upper", "m", upper.component, 3);
  if (lower != domain_.lower || upper != domain_.upper)
    state.refuse("domain_lower", "or 'domain_upper' is not that of the periodic boundaries here");
  if (!extrapolated) return;
  planes_before_extrapolation_.resize(planes_.size());
  transfer_planes(state.below("before_extrapolation"), planes_before_extrapolation_);
}

Boundaries::StoredPlanes Boundaries::stored_planes(const State& state, std::size_t boundary) {
  const StateTransfer of_member =
      StateTransfer::restoring_from(state).below("walls").below(std::to_string(boundary));
  StoredPlanes planes = {0, 0};
  of_member.value("first_plane", "", planes.first);
  of_member.value("plane_count", "1", planes.count);
  return planes;
}

std::size_t Boundaries::plane_count(const State& state) { return state.at("walls/planes/point").size() / 3; }

void Boundaries::take_over(const State& state, std::size_t from, const std::string& name) {
  const StateTransfer walls = StateTransfer::restoring_from(state).below("walls"),
                      of_member = walls.below(std::to_string(from));
  for (Member& member : members_) {
    if (member.entry.name != name) continue;
    const auto [first_plane, count] = stored_planes(state, from);
    of_member.sized_rows("state", "1", member.state, 1, stored::any);
    of_member.value("kinetic", "J", member.energy.kinetic, stored::any);
    std::vector<scree_plane> all(plane_count(state));
    transfer_planes(walls.below("planes"), all);
    const std::span<scree_plane> planes = planes_of(member);
    if (count != planes.size() || count > all.size() || first_plane > all.size() - count)
      of_member.refuse("plane_count", "is not that of the boundary here");
    std::copy_n(all.begin() + std::ptrdiff_t(first_plane), planes.size(), planes.begin());
  }
}

void Boundaries::configure_by_clock(Member& member) {
  member.plugin = ConfiguredBoundary(member.clock.shown(member.entry.parameters), dimension_, lower_, upper_);
}

void Boundaries::begin_anew() {
  for (Member& member : members_) {
    const bool others = std::exchange(member.clock, {}).shows_others();
    if (others) configure_by_clock(member);
    member.energy.work = member.energy.dissipated = 0;
  }
}

}  // namespace scree
