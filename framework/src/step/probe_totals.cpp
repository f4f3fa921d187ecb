#include "step/probe_totals.hpp"

#include "plugins/view_columns.hpp"
#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <scree/scene_record.hpp>
#include <scree/simulation.hpp>

namespace scree {

ProbeTotals::ProbeTotals(SimulationParts& parts, const Probe& probe, const scree_view& walls)
    : parts_(parts), probe_(probe), part_(walls) {
  const Particles& p = parts.particles;
  show(p, part_);
  for (std::size_t place = 0; place < probe.left_out().size(); ++place)
    left_out_.push_back(probe.left_out()[p.order().number(place)]);
  if (!left_out_.empty()) part_.left_out = left_out_.data();
  if (parts.share && (probe.needs() & (SCREE_NEEDS_CONTACTS | SCREE_NEEDS_CONTACT_COUNTS)))
    parts.forces.bring_bodies_of_others(parts.particles);
  if (probe.needs() & SCREE_NEEDS_CONTACT_COUNTS) count_contacts();
}

void ProbeTotals::count_contacts() {
  contacts_of_body_.resize(parts_.particles.size());
  scree::count_contacts(parts_.particles, parts_.contacts, parts_.boundaries, contacts_of_body_);
  if (parts_.share) parts_.forces.return_counts(contacts_of_body_);
  part_.contacts_of_body = contacts_of_body_.data();
}

std::vector<double> ProbeTotals::all() {
  return probe_.totals(
      [this](std::uint32_t pass, const std::vector<double>& before) { return of_pass(pass, before); });
}

std::vector<double> ProbeTotals::of_tile(std::size_t tile, std::uint32_t pass,
                                         const std::vector<double>& before) const {
  scree_view part = part_;
  const BodyRange bodies = BodyTiles(parts_.particles.size())[tile];
  part.part_begin = bodies.begin;
  part.part_end = bodies.end;
  part.totals = before.data();
  ContactList contacts;
  if (probe_.needs() & SCREE_NEEDS_CONTACTS) {
    contacts = touching_contacts_of(
        {parts_.particles, parts_.contacts, parts_.forces.pair_forces(), parts_.laws, parts_.boundaries},
        tile);
    show(contacts, part);
  }
  return probe_.totals_of_part(part, pass);
}

void ProbeTotals::Partial::add(const std::vector<double>& of_tile) {
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k].add(of_tile[k]);
  for (std::size_t k = 0; k < largest.size(); ++k)
    largest[k] = std::max(largest[k], of_tile[sums.size() + k]);
}

void ProbeTotals::Partial::add(const Partial& other) {
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k].add(other.sums[k]);
  for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], other.largest[k]);
}

std::vector<double> ProbeTotals::of_pass(std::uint32_t pass, const std::vector<double>& before) {
  const std::size_t sums = probe_.first_largest();
  const Partial nothing = {
      std::vector<ExactSum>(sums),
      std::vector<double>(before.size() - sums, -std::numeric_limits<double>::infinity())};
  std::vector<Partial> of_worker(parts_.threads->size(), nothing);
  const auto add_tile = [&](std::size_t tile, unsigned worker) {
    of_worker[worker].add(of_tile(tile, pass, before));
  };
  if (!parts_.share)
    parts_.threads->each(BodyTiles(parts_.particles.size()).count(), add_tile);
  else
    parts_.threads->each(parts_.share->owners.own().size(), [&](std::size_t k, unsigned worker) {
      parts_.share->failure.guard([&] { add_tile(parts_.share->owners.own()[k], worker); });
    });
  for (std::size_t w = 1; w < of_worker.size(); ++w) of_worker[0].add(of_worker[w]);
  return over_ranks(of_worker[0]);
}

std::vector<double> ProbeTotals::over_ranks(const Partial& own) {
  std::vector<double> totals(own.sums.size());
  totals.insert(totals.end(), own.largest.begin(), own.largest.end());
  bool sound = !parts_.share || !parts_.share->failure.any();
  RankSums sums(parts_.ranks());
  for (std::size_t k = 0; k < own.sums.size(); ++k) sums.sum(totals[k], own.sums[k]);
  for (std::size_t k = own.sums.size(); k < totals.size(); ++k) sums.largest(totals[k]);
  sums.all(sound);
  sums.close();
  if (!sound) parts_.share->failure.throw_on_all(parts_.share->ranks);
  return totals;
}

void SimulationParts::command_totals(const Probe& probe) {
  if (!share || !share->is_first()) return;
  std::vector<std::string> lines = {std::to_string(probe.number())};
  const bool is_new = sent_probes.insert(probe.number()).second;
  if (is_new) {
    lines.emplace_back(probe.parameters().plugin().name);
    for (std::string& line : parameter_lines(probe.parameters())) lines.push_back(std::move(line));
  }
  command(RankCommand::add_totals, lines);
  if (!is_new) return;
  std::vector<std::uint8_t> left_out = probe.left_out();
  std::uint64_t size = left_out.size();
  share->ranks.broadcast(std::as_writable_bytes(std::span(&size, 1)));
  share->ranks.broadcast(std::as_writable_bytes(std::span(left_out)));
}

std::vector<double> Simulation::totals_of(const Probe& probe) const {
  if (!probe.has_totals()) return {};
  parts_->command_totals(probe);
  const SimulationView walls(*this, SCREE_NEEDS_NO_BODIES);
  return ProbeTotals(*parts_, probe, walls.get()).all();
}

}  // namespace scree
