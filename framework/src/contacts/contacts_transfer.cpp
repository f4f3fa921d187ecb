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
    const bool listed = with_planes ? pairs.b[q] < planes : pairs.a[q] < pairs.b[q] && pairs.b[q] < bodies;
    if (pairs.a[q] >= bodies || !listed || pairs.image[q] >= images)
      state.refuse("b", "lists a pair of bodies or walls that the scene does not have");
    if (q > 0 && std::tie(pairs.a[q - 1], pairs.b[q - 1]) >= std::tie(pairs.a[q], pairs.b[q]))
      state.refuse("a", "lists pairs that are not sorted");
  }
}

std::vector<std::uint32_t> rows_with_history(const PairGroup& group) {
  std::vector<std::uint32_t> rows;
  for (std::size_t row = 0; row < group.end - group.begin; ++row)
    if (group.history.is_used(row)) rows.push_back(std::uint32_t(row));
  return rows;
}

void transfer_history(const StateTransfer& state, PairGroup& group) {
  if (group.history_width == 0) return;
  std::vector<std::uint32_t> rows;
  if (!state.restoring()) rows = rows_with_history(group);
  state.rows("history_row", "", rows);
  for (const std::uint32_t row : rows)
    if (row >= group.end - group.begin) state.refuse("history_row", "lists a pair that there is not");
  group.history.transfer(state, "history", "1", rows);
}

}  // namespace

void Contacts::transfer(const StateTransfer& state, std::size_t bodies, std::size_t planes) {
  if (state.restoring()) a.clear(), b.clear(), image.clear();
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    PairGroup& group = groups_[g];
    const StateTransfer of_group = state.below(std::to_string(g));
    Pairs pairs;
    if (!state.restoring()) {
      const auto begin = std::ptrdiff_t(group.begin), end = std::ptrdiff_t(group.end);
      pairs = {{a.begin() + begin, a.begin() + end},
               {b.begin() + begin, b.begin() + end},
               {image.begin() + begin, image.begin() + end}};
    }
    std::uint32_t law = group.law;
    bool with_planes = group.planes;
    of_group.value("law", "", law);
    of_group.value("planes", "", with_planes);
    if (law != group.law || with_planes != group.planes)
      of_group.refuse("law", "is the law of other contacts");
    if (state.restoring()) {
      of_group.rows("a", "", pairs.a);
      pairs.b.resize(pairs.a.size()), pairs.image.resize(pairs.a.size());
    } else {
      of_group.moved_rows("a", "", pairs.a);
    }
    of_group.moved_rows("b", "", pairs.b);
    of_group.moved_rows("image", "", pairs.image);
    if (state.restoring()) {
      check(of_group, pairs, group.planes, bodies, planes);
      group.begin = a.size();
      a.insert(a.end(), pairs.a.begin(), pairs.a.end());
      b.insert(b.end(), pairs.b.begin(), pairs.b.end());
      image.insert(image.end(), pairs.image.begin(), pairs.image.end());
      append_padding(group);
    }
    transfer_history(of_group, group);
  }
  if (state.restoring()) ++revision_;
}

}  // namespace scree
