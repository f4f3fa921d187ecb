#include "pieces.hpp"

#include <utility>
#include <vector>

#include <catch2/catch.hpp>

using namespace scree;

namespace {

// Begin and end of each piece.
using Ends = std::vector<std::pair<int, int>>;

Ends pieces_of(int count, std::size_t longest) {
  std::vector<int> items;
  for (int k = 0; k < count; ++k) items.push_back(k);
  Ends ends;
  ranks::each_piece(std::span(items), longest, [&](std::span<int> piece) {
    ends.push_back({piece.front(), piece.back() + 1});
  });
  return ends;
}

}  // namespace

TEST_CASE("a message is split into consecutive pieces", "[pieces]") {
  CHECK(pieces_of(0, 3).empty());
  CHECK(pieces_of(2, 3) == Ends{{0, 2}});
  CHECK(pieces_of(3, 3) == Ends{{0, 3}});
  CHECK(pieces_of(7, 3) == Ends{{0, 3}, {3, 6}, {6, 7}});
}
