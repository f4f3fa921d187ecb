// Messages between ranks, counted body by body: the check of lattice.cpp. The packing of beads-4096 is
// repeated and sorted by spatial_order of the framework.
//
// Usage: positions RANKS PACKING REPEAT           as lattice; REPEAT copies along each axis
//        positions planes PACKING REPEAT          what a plane through the packing cuts, for lattice.cpp

#include "ranges.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <string>

#include <scree/spatial_order.hpp>

namespace {

using namespace ranks_model;

// Gap between surfaces up to which pairs are listed, in metres: 3.14 pairs a body, as scree lists in
// beads-4096.
constexpr double skin = 3e-6;

using Bodies = std::vector<scree::Sphere>;
using Pairs = std::vector<std::array<std::uint32_t, 2>>;

struct Packing {
  Bodies bodies;
  std::array<double, 3> size;
};

Packing read(const std::string& path, int repeat) {
  std::ifstream file(path);
  std::size_t number = 0;
  double width = 0, height = 0;
  file >> number >> width >> height;
  Bodies once(number);
  for (scree::Sphere& body : once)
    file >> body.position[0] >> body.position[1] >> body.position[2] >> body.radius;
  Packing result{{}, {width * repeat, height * repeat, width * repeat}};
  for (int copy = 0; copy < repeat * repeat * repeat; ++copy)
    for (scree::Sphere body : once) {
      body.position[0] += width * (copy % repeat);
      body.position[1] += height * (copy / repeat % repeat);
      body.position[2] += width * (copy / repeat / repeat);
      result.bodies.push_back(body);
    }
  return result;
}

// Grid of cells as wide as the largest reach; bodies by cell.
class Cells {
 public:
  Cells(const Packing& packing, double reach) : bodies_(packing.bodies) {
    for (int k = 0; k < 3; ++k) {
      number_[k] = std::max(1, int(packing.size[k] / reach));
      width_[k] = packing.size[k] / number_[k];
    }
    members_.resize(std::size_t(number_[0]) * number_[1] * number_[2]);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      int at[3];
      for (int k = 0; k < 3; ++k)
        at[k] = std::clamp(int(bodies_[i].position[k] / width_[k]), 0, number_[k] - 1);
      members_[index(at)].push_back(std::uint32_t(i));
    }
  }

  Pairs pairs() const {
    Pairs found;
    for (int z = 0; z < number_[2]; ++z)
      for (int y = 0; y < number_[1]; ++y)
        for (int x = 0; x < number_[0]; ++x)
          for (int step = 0; step < 27; ++step) {
            const int at[] = {x, y, z};
            const int near[] = {x + step % 3 - 1, y + step / 3 % 3 - 1, z + step / 9 - 1};
            if (inside(near)) select(members_[index(at)], members_[index(near)], found);
          }
    return found;
  }

 private:
  std::size_t index(const int* at) const {
    return (std::size_t(at[2]) * number_[1] + at[1]) * number_[0] + at[0];
  }
  bool inside(const int* at) const {
    for (int k = 0; k < 3; ++k)
      if (at[k] < 0 || at[k] >= number_[k]) return false;
    return true;
  }
  void select(const std::vector<std::uint32_t>& cell, const std::vector<std::uint32_t>& other,
              Pairs& found) const {
    for (const std::uint32_t i : cell)
      for (const std::uint32_t j : other) {
        if (j <= i) continue;
        double square = 0;
        for (int k = 0; k < 3; ++k) square += std::pow(bodies_[i].position[k] - bodies_[j].position[k], 2);
        if (square < std::pow(bodies_[i].radius + bodies_[j].radius + skin, 2)) found.push_back({i, j});
      }
  }

  const Bodies& bodies_;
  std::array<int, 3> number_;
  std::array<double, 3> width_;
  std::vector<std::vector<std::uint32_t>> members_;
};

Pairs pairs_of(const Packing& packing) {
  double largest = 0;
  for (const scree::Sphere& body : packing.bodies) largest = std::max(largest, body.radius);
  return Cells(packing, 2 * largest + skin).pairs();
}

// Planes across each axis, in the inner half of the packing.
void print_planes(const Packing& packing, const Pairs& pairs) {
  const double volume = packing.size[0] * packing.size[1] * packing.size[2];
  const double unit = std::cbrt(volume / double(packing.bodies.size()));
  double records = 0, loads = 0, area = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int plane = 0; plane < 40; ++plane) {
      const double at = packing.size[axis] * (0.25 + 0.5 * plane / 40);
      std::vector<std::uint32_t> above;
      for (auto [i, j] : pairs) {
        if (packing.bodies[i].position[axis] > packing.bodies[j].position[axis]) std::swap(i, j);
        if (packing.bodies[i].position[axis] < at && packing.bodies[j].position[axis] >= at)
          above.push_back(j);
      }
      loads += double(above.size());
      std::sort(above.begin(), above.end());
      records += double(std::unique(above.begin(), above.end()) - above.begin());
      area += volume / packing.size[axis] / (unit * unit);
    }
  std::printf("pairs a body %.3f, of an area of one body: bodies %.3f, pairs %.3f\n",
              double(pairs.size()) / double(packing.bodies.size()), records / area, loads / area);
}

// Pairs by place: the lower place first.
void to_places(const Packing& packing, Pairs& pairs) {
  const std::vector<std::uint32_t> order = scree::spatial_order(packing.bodies, 3);
  std::vector<std::uint32_t> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = std::uint32_t(k);
  for (auto& [i, j] : pairs) {
    i = place[i], j = place[j];
    if (i > j) std::swap(i, j);
  }
}

void print_ranks(std::size_t bodies, const Pairs& pairs, std::size_t ranks) {
  std::vector<Tile> tiles(tile_count(bodies));
  const auto tile = [&](std::size_t body) { return std::min(body / tile_size, tiles.size() - 1); };
  for (std::size_t i = 0; i < bodies; ++i) ++tiles[tile(i)].bodies;
  for (const auto& [i, j] : pairs) ++(tile(i) == tile(j) ? tiles[tile(i)].inner : tiles[tile(i)].cross);
  const std::vector<std::size_t> rank = rank_of_tiles(tiles, ranks);
  Halos halos(ranks);
  std::vector<std::array<std::size_t, 2>> read;  // rank, body of another one
  for (const auto& [i, j] : pairs) {
    const std::size_t low = rank[tile(i)], high = rank[tile(j)];
    if (low == high) continue;
    ++halos[low][high].loads;
    read.push_back({low, j});
  }
  std::sort(read.begin(), read.end());
  read.erase(std::unique(read.begin(), read.end()), read.end());
  for (const auto& [low, body] : read) ++halos[low][rank[tile(body)]].records;
  print(tiles, rank, halos);
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fputs("usage: positions RANKS|planes PACKING REPEAT\n", stderr);
    return 2;
  }
  const Packing packing = read(words[2], std::atoi(words[3]));
  Pairs pairs = pairs_of(packing);
  if (std::string(words[1]) == "planes") {
    print_planes(packing, pairs);
  } else {
    to_places(packing, pairs);
    print_ranks(packing.bodies.size(), pairs, std::size_t(std::atof(words[1])));
  }
}
