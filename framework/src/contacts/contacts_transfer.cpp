#include "contacts/contacts.hpp"

#include <string>
#include <tuple>

#include <scree/state_transfer.hpp>

namespace scree {

namespace {

// The pairs of a group without padding.
struct Pairs {
  std::vector<std::uint32_t> a, b;
  std::vector<std::uint8_t> image;
};

// Pairs index bodies and planes, and histories are found by their order.
void check(const StateTransfer& state, const Pairs& pairs, bool with_planes, std::size_t bodies,
           std::size_t planes) {
  constexpr std::uint8_t images = 27;
  for (std::size_t q = 0; q < pairs.a.size(); ++q) {
    const bool listed = with_planes ? pairs.b[q] < planes && pairs.image[q] >= Domain::no_shift
                                    : pairs.a[q] < pairs.b[q] && pairs.b[q] < bodies;
    if (pairs.a[q] >= bodies || !listed || pairs.image[q] >= images)
      state.refuse("b", "lists a pair of bodies or walls that the scene does not have");
    // A body may meet a wall in several spots.
    const auto key = [&](std::size_t k) {
      return std::tuple(pairs.a[k], pairs.b[k], with_planes ? pairs.image[k] : 0);
    };
    if (q > 0 && key(q - 1) >= key(q)) state.refuse("a", "lists pairs that are not sorted");
  }
}

}  // namespace

// <name>_row counts the pairs of the group in scene order; storage has their rows in the group.
void Contacts::transfer_columns(const StateTransfer& state, const std::string& name, const char* unit,
                                PairColumns& columns, const std::vector<std::uint32_t>& storage) {
  std::vector<std::uint32_t> rows, stored;
  for (std::size_t k = 0; !state.restoring() && k < storage.size(); ++k)
    if (columns.is_used(storage[k])) rows.push_back(std::uint32_t(k));
  state.rows(name + "_row", "", rows);
  for (const std::uint32_t row : rows) {
    if (row >= storage.size()) state.refuse(name + "_row", "lists a pair that there is not");
    stored.push_back(storage[row]);
  }
  columns.transfer(state, name, unit, stored);
}

std::vector<std::uint32_t> Contacts::save_pairs(const StateTransfer& state, const PairGroup& group,
                                                const BodyOrder& order) const {
  Pairs pairs;
  std::vector<std::uint32_t> storage;
  for (const std::size_t q : in_scene_order(group, order)) {
    pairs.a.push_back(order.number(a[q]));
    pairs.b.push_back(group.planes ? b[q] : order.number(b[q]));
    pairs.image.push_back(image[q]);
    storage.push_back(std::uint32_t(q - group.begin));
  }
  state.moved_rows("a", "", pairs.a);
  state.moved_rows("b", "", pairs.b);
  state.moved_rows("image", "", pairs.image);
  return storage;
}

std::vector<std::uint32_t> Contacts::restore_pairs(const StateTransfer& state, PairGroup& group,
                                                   const BodyOrder& order, std::size_t planes) {
  Pairs pairs;
  state.rows("a", "", pairs.a);
  pairs.b.resize(pairs.a.size()), pairs.image.resize(pairs.a.size());
  state.moved_rows("b", "", pairs.b);
  state.moved_rows("image", "", pairs.image);
  check(state, pairs, group.planes, tiles_.size(), planes);
  std::vector<Listed> listed(pairs.a.size());
  for (std::uint32_t k = 0; k < listed.size(); ++k)
    listed[k] = {order.place(pairs.a[k]), group.planes ? pairs.b[k] : order.place(pairs.b[k]), pairs.image[k],
                 k};
  std::vector<std::uint32_t> storage(listed.size());
  for (const PairColumns::Move& row : fill_unsorted(group, listed)) storage[row.from] = row.to;
  return storage;
}

void Contacts::transfer(const StateTransfer& state, const BodyOrder& order, std::size_t planes) {
  if (state.restoring()) a.clear(), b.clear(), image.clear();
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& group = groups_[g];
    const StateTransfer of_group = state.below(std::to_string(g));
    std::uint32_t law = group.law;
    bool with_planes = group.planes;
    of_group.value("law", "", law);
    of_group.value("planes", "", with_planes);
    if (law != group.law || with_planes != group.planes)
      of_group.refuse("law", "is the law of other contacts");
    const std::vector<std::uint32_t> storage = state.restoring()
                                                   ? restore_pairs(of_group, group, order, planes)
                                                   : save_pairs(of_group, group, order);
    if (group.history_width > 0) transfer_columns(of_group, "history", "1", group.history, storage);
    if (group.spot_width > 0) transfer_columns(of_group, "spot", "m", group.spots, storage);
  }
  if (state.restoring()) ++revision_;
}

}  // namespace scree
