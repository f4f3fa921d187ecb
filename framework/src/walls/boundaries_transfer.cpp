#include "surfaces/frame_transfer.hpp"
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
    if (surfaces_.size() > 0) {
      std::uint64_t first_surface = member.first_surface, surfaces = member.plugin.instance().surface_count;
      of_member.value("first_surface", "", first_surface);
      of_member.value("surface_count", "1", surfaces);
      if (first_surface != member.first_surface || surfaces != member.plugin.instance().surface_count)
        of_member.refuse("surface_count", "or 'first_surface' is not that of the boundary here");
    }
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
  if (surfaces_.size() > 0) transfer_surfaces(state.below("surfaces"), extrapolated);
  Vec3 lower = domain_.lower, upper = domain_.upper;
  state.numbers("domain_lower", "m", lower.component, 3);
  state.numbers("domain_upper", "m", upper.component, 3);
  if (lower != domain_.lower || upper != domain_.upper)
    state.refuse("domain_lower", "or 'domain_upper' is not that of the periodic boundaries here");
  if (!extrapolated) return;
  planes_before_extrapolation_.resize(planes_.size());
  transfer_planes(state.below("before_extrapolation"), planes_before_extrapolation_);
}

void Boundaries::transfer_surfaces(const StateTransfer& state, bool extrapolated) {
  transfer_frames(state, surfaces_.frames);
  double* const loads = surfaces_.loads[0].force;
  state.vectors("load", "N", {loads, 6, surfaces_.size(), 0, 3}, 0, 3);
  state.vectors("torque", "N m", {loads + 3, 6, surfaces_.size(), 0, 3}, 0, 3);
  if (!extrapolated) return;
  frames_before_extrapolation_.resize(surfaces_.size());
  transfer_frames(state.below("before_extrapolation"), frames_before_extrapolation_);
}

Boundaries::StoredWalls Boundaries::stored_walls(const State& state, std::size_t boundary) {
  const StateTransfer of_member =
      StateTransfer::restoring_from(state).below("walls").below(std::to_string(boundary));
  StoredWalls stored;
  of_member.value("first_plane", "", stored.first_plane);
  of_member.value("plane_count", "1", stored.planes);
  if (!of_member.has("surface_count")) return stored;  // no boundary has any
  of_member.value("first_surface", "", stored.first_surface);
  of_member.value("surface_count", "1", stored.surfaces);
  return stored;
}

std::size_t Boundaries::plane_count(const State& state) { return state.at("walls/planes/point").size() / 3; }

std::size_t Boundaries::surface_count(const State& state) {
  constexpr const char* positions = "walls/surfaces/position";
  return state.has(positions) ? state.at(positions).size() / 3 : 0;
}

void Boundaries::take_over_surfaces(const State& state, const StoredWalls& stored, Member& member) {
  std::vector<scree_frame> all(surface_count(state));
  const StateTransfer surfaces = StateTransfer::restoring_from(state).below("walls").below("surfaces");
  if (!all.empty()) transfer_frames(surfaces, all);
  const std::span<scree_frame> frames = frames_of(member);
  if (stored.surfaces != frames.size() || stored.surfaces > all.size() ||
      stored.first_surface > all.size() - stored.surfaces)
    surfaces.refuse("position", "has not the surfaces of the boundary here");
  std::copy_n(all.begin() + std::ptrdiff_t(stored.first_surface), frames.size(), frames.begin());
}

void Boundaries::take_over(const State& state, std::size_t from, const std::string& name) {
  const StateTransfer walls = StateTransfer::restoring_from(state).below("walls"),
                      of_member = walls.below(std::to_string(from));
  for (Member& member : members_) {
    if (member.entry.name != name) continue;
    const StoredWalls stored = stored_walls(state, from);
    const auto [first_plane, count] = std::pair(stored.first_plane, stored.planes);
    of_member.sized_rows("state", "1", member.state, 1, stored::any);
    of_member.value("kinetic", "J", member.energy.kinetic, stored::any);
    std::vector<scree_plane> all(plane_count(state));
    transfer_planes(walls.below("planes"), all);
    const std::span<scree_plane> planes = planes_of(member);
    if (count != planes.size() || count > all.size() || first_plane > all.size() - count)
      of_member.refuse("plane_count", "is not that of the boundary here");
    std::copy_n(all.begin() + std::ptrdiff_t(first_plane), planes.size(), planes.begin());
    take_over_surfaces(state, stored, member);
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
