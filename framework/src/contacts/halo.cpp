#include "contacts/halo.hpp"

#include "ranks/messages.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace scree {

using Arrival = kernel::Tiles::Arrival;

namespace {

// Begins one message to and from each rank that has rows.
void begin_messages(Ranks& ranks, const std::vector<std::size_t>& first_sent, const double* sent,
                    std::size_t width_sent, const std::vector<std::size_t>& first_received, double* received,
                    std::size_t width_received) {
  std::vector<Ranks::Sent> to;
  std::vector<Ranks::Received> from;
  for (unsigned r = 0; r < ranks.size(); ++r) {
    if (const std::size_t rows = first_sent[r + 1] - first_sent[r])
      to.push_back({r, {sent + first_sent[r] * width_sent, rows * width_sent}});
    if (const std::size_t rows = first_received[r + 1] - first_received[r])
      from.push_back({r, {received + first_received[r] * width_received, rows * width_received}});
  }
  ranks.begin(to, from);
}

// Parts of three components.
std::vector<std::size_t> components(std::initializer_list<std::size_t> parts) {
  std::vector<std::size_t> numbers;
  for (const std::size_t part : parts) numbers.insert(numbers.end(), {part, part + 1, part + 2});
  return numbers;
}

// The numbers of a record that change in a step.
std::vector<std::size_t> moving_numbers(const Particles& p) {
  using namespace record;
  if (p.dimension() == 3 && p.has_spin()) return components({position, motion, mid_motion, spin, mid_spin});
  if (p.dimension() == 3) return components({position, motion, mid_motion});
  std::vector<std::size_t> numbers = components({motion, mid_motion});
  numbers.insert(numbers.end(), {position, position + 1});
  return numbers;
}

// The numbers of a load that are not always 0.
std::vector<std::size_t> load_numbers(const Particles& p) {
  return p.dimension() == 3 && p.has_spin() ? components({0, 4}) : components({0});
}

template <class Items>
std::vector<std::size_t> first_of_each(const std::vector<Items>& lists) {
  std::vector<std::size_t> first = {0};
  for (const Items& list : lists) first.push_back(first.back() + list.size());
  return first;
}

}  // namespace

// Loads of pairs of this rank on bodies of each other rank, in the order of tiles and their slots.
std::vector<std::vector<Arrival>> Halo::find_departures(const kernel::Tiles& tiles) {
  std::vector<std::vector<Arrival>> departures(ranks_.size());
  std::vector<std::vector<std::uint32_t>> slots(ranks_.size());
  reads_others_.assign(owners_.tiles(), 0);
  for (const std::uint32_t tile : owners_.own())
    for (const kernel::Tiles::Incoming& out : tiles.outgoing(tile)) {
      const std::uint32_t rank = owners_.rank_of(tiles.bodies().owner(out.body));
      if (rank == owners_.rank()) continue;
      reads_others_[tile] = 1;
      departures[rank].push_back({tile, out.body});
      slots[rank].push_back(out.slot);
    }
  slots_sent_ = {{}, first_of_each(slots)};
  for (const std::vector<std::uint32_t>& of_rank : slots)
    slots_sent_.rows.insert(slots_sent_.rows.end(), of_rank.begin(), of_rank.end());
  return departures;
}

// The bodies that this rank loads are those that it reads.
void Halo::agree_on_records(const std::vector<std::vector<Arrival>>& departures) {
  std::vector<std::vector<std::uint32_t>> wanted(ranks_.size());
  for (std::size_t r = 0; r < wanted.size(); ++r) {
    for (const Arrival& load : departures[r]) wanted[r].push_back(load.body);
    std::sort(wanted[r].begin(), wanted[r].end());
    wanted[r].erase(std::unique(wanted[r].begin(), wanted[r].end()), wanted[r].end());
  }
  const auto joined = [](const std::vector<std::vector<std::uint32_t>>& lists) {
    Rows rows = {{}, first_of_each(lists)};
    for (const std::vector<std::uint32_t>& list : lists)
      rows.rows.insert(rows.rows.end(), list.begin(), list.end());
    return rows;
  };
  places_received_ = joined(wanted);
  places_sent_ = joined(exchange_items(ranks_, wanted));
}

void Halo::agree_on_loads(const std::vector<std::vector<Arrival>>& departures, kernel::Tiles& tiles) {
  const std::vector<std::vector<Arrival>> of_ranks = exchange_items(ranks_, departures);
  first_arrival_ = first_of_each(of_ranks);
  std::vector<Arrival> arrivals;
  loaded_by_others_.assign(owners_.tiles(), 0);
  for (const std::vector<Arrival>& of_rank : of_ranks)
    for (const Arrival& load : of_rank) {
      arrivals.push_back(load);
      loaded_by_others_[tiles.bodies().owner(load.body)] = 1;
    }
  first_arrival_slot_ = tiles.add_arrivals(arrivals);
}

std::size_t Halo::record_width(const Particles& particles) const {
  return moving_numbers(particles).size() + (orientations_ ? particles.orientations.stride() : 0);
}

void Halo::plan(kernel::Tiles& tiles, Particles& particles, bool orientations) {
  orientations_ = orientations;
  const std::vector<std::vector<Arrival>> departures = find_departures(tiles);
  agree_on_records(departures);
  agree_on_loads(departures, tiles);
  records_sent_.resize(places_sent_.rows.size() * record_width(particles));
  records_received_.resize(places_received_.rows.size() * record_width(particles));
  const std::size_t width = load_numbers(particles).size();
  loads_sent_.resize(slots_sent_.rows.size() * width);
  loads_received_.resize(first_arrival_.back() * width);
#ifndef NDEBUG
  poison(particles);
#endif
  bring_constants(particles);
}

void Halo::bring_constants(Particles& particles) {
  particles.each_constant([&](auto& column, std::size_t width) {
    using Item = std::remove_reference_t<decltype(column[0])>;
    if (column.empty()) return;
    std::vector<std::vector<Item>> sent(ranks_.size());
    for (std::size_t r = 0; r < sent.size(); ++r)
      for (std::size_t k = places_sent_.first[r]; k < places_sent_.first[r + 1]; ++k) {
        const Item* const row = column.data() + places_sent_.rows[k] * width;
        sent[r].insert(sent[r].end(), row, row + width);
      }
    const std::vector<std::vector<Item>> received = exchange_items(ranks_, std::move(sent));
    for (std::size_t r = 0; r < received.size(); ++r)
      for (std::size_t k = places_received_.first[r]; k < places_received_.first[r + 1]; ++k)
        std::copy_n(received[r].data() + (k - places_received_.first[r]) * width, width,
                    column.data() + places_received_.rows[k] * width);
  });
}

void Halo::poison(Particles& p) const {
  std::vector<char> known(p.size(), 0);
  for (const std::uint32_t place : places_received_.rows) known[place] = 1;
  for (std::size_t place = 0; place < p.size(); ++place) {
    if (known[place] || owners_.is_own(BodyTiles(p.size()).owner(place))) continue;
    for (int k = 0; k < p.dimension(); ++k)
      p.position()[k][place] = p.velocity()[k][place] = std::numeric_limits<double>::quiet_NaN();
  }
}

void Halo::begin_records(const Particles& p) {
  const std::vector<std::size_t> numbers = moving_numbers(p);
  double* next = records_sent_.data();
  for (const std::uint32_t place : places_sent_.rows) {
    const double* const record = p.records() + place * p.width();
    for (const std::size_t number : numbers) *next++ = record[number];
    const std::size_t turned = orientations_ ? p.orientations.stride() : 0;
    next = std::copy_n(p.orientations.data() + place * turned, turned, next);
  }
  begin_messages(ranks_, places_sent_.first, records_sent_.data(), record_width(p), places_received_.first,
                 records_received_.data(), record_width(p));
}

void Halo::finish_records(Particles& p) {
  ranks_.finish();
  const std::vector<std::size_t> numbers = moving_numbers(p);
  const double* next = records_received_.data();
  for (const std::uint32_t place : places_received_.rows) {
    double* const record = p.records() + place * p.width();
    for (const std::size_t number : numbers) record[number] = *next++;
    const std::size_t turned = orientations_ ? p.orientations.stride() : 0;
    std::copy_n(next, turned, p.orientations.data() + place * turned);
    next += turned;
  }
}

void Halo::begin_loads(const Particles& p) {
  const std::vector<std::size_t> numbers = load_numbers(p);
  double* next = loads_sent_.data();
  for (const std::uint32_t slot : slots_sent_.rows) {
    const double* const load = p.loads() + slot * p.load_width();
    for (const std::size_t number : numbers) *next++ = load[number];
  }
  begin_messages(ranks_, slots_sent_.first, loads_sent_.data(), numbers.size(), first_arrival_,
                 loads_received_.data(), numbers.size());
}

void Halo::finish_loads(Particles& p) {
  ranks_.finish();
  const std::vector<std::size_t> numbers = load_numbers(p);
  const double* next = loads_received_.data();
  double* load = p.loads() + first_arrival_slot_ * p.load_width();
  for (std::size_t k = 0; k < first_arrival_.back(); ++k, load += p.load_width()) {
    std::fill_n(load, p.load_width(), 0.0);
    for (const std::size_t number : numbers) load[number] = *next++;
  }
}

void Halo::return_counts(BodyColumn<std::uint32_t>& counts) {
  std::vector<double> sent, received(places_sent_.rows.size());
  for (const std::uint32_t place : places_received_.rows) sent.push_back(counts[place]);
  begin_messages(ranks_, places_received_.first, sent.data(), 1, places_sent_.first, received.data(), 1);
  ranks_.finish();
  for (std::size_t k = 0; k < received.size(); ++k)
    counts[places_sent_.rows[k]] += std::uint32_t(received[k]);
}

std::size_t Halo::foreign_bodies() const { return places_received_.rows.size(); }

}  // namespace scree
