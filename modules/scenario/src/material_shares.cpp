#include "readers.hpp"

#include <cmath>

#include <fmt/format.h>

namespace scree::scenario {

namespace {

struct Share {
  std::string material;
  double part;  // of the number of bodies
};

std::vector<Share> read_shares(const document::Table& table, const std::vector<Material>& materials) {
  constexpr double rounding = 1e-6;
  std::vector<Share> shares;
  double sum = 0;
  for (const std::string& name : table.keys()) {
    find_name(table, name, "material", name, names_of(materials));
    shares.push_back({name, table.number(name, Range::between(0, 1))});
    sum += shares.back().part;
  }
  if (!(std::abs(sum - 1) <= rounding))
    throw table.error(fmt::format("the shares of the materials add up to {:g}", sum),
                      "make them add up to 1");
  return shares;
}

}  // namespace

void share_materials(const document::Table& table, const std::vector<Material>& materials,
                     packing::Random& random, std::vector<packing::Body>& bodies) {
  std::vector<packing::Body*> left;
  for (packing::Body& body : bodies)
    if (body.material.empty()) left.push_back(&body);
  for (std::size_t k = left.size(); k > 1; --k) std::swap(left[k - 1], left[random.bits() % k]);
  double up_to = 0;
  std::size_t next = 0;
  for (const Share& share : read_shares(table, materials)) {
    up_to += share.part;
    const auto end = std::min(left.size(), std::size_t(std::llround(up_to * double(left.size()))));
    for (; next < end; ++next) left[next]->material = share.material;
  }
}

}  // namespace scree::scenario
