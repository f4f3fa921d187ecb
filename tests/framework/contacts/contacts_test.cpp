#include "contacts/contacts.hpp"

#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

using scree::Contacts;
using scree::NeighbourPair;
using scree::PairGroup;
using scree::PlanePair;

namespace {

constexpr std::size_t body_count = 40, plane_count = 3;
constexpr std::uint32_t history_widths[] = {3, 5};  // history columns of the two laws

// Materials 0, 1, 2; law 1 acts between different materials. Bodies and planes have the materials in turn.
struct Table {
  std::vector<std::uint32_t> law_of = {0, 1, 1, 1, 0, 1, 1, 1, 0};
  std::vector<std::uint32_t> body_material, plane_material;

  Table() {
    for (std::uint32_t i = 0; i < body_count; ++i) body_material.push_back(i % 3);
    for (std::uint32_t i = 0; i < plane_count; ++i) plane_material.push_back(i % 3);
  }
  Contacts::Lookup lookup() const { return {law_of.data(), 3, body_material.data(), plane_material.data()}; }
  std::uint32_t law(bool plane, std::uint32_t a, std::uint32_t b) const {
    return law_of[body_material[a] * 3 + (plane ? plane_material[b] : body_material[b])];
  }
};

struct ListedPairs {
  std::vector<NeighbourPair> body;
  std::vector<PlanePair> plane;
};

// Each possible pair is listed with this probability; sorted, as by a search.
ListedPairs some_pairs(double probability, unsigned seed) {
  std::mt19937 generator(seed);
  std::bernoulli_distribution present(probability);
  ListedPairs pairs;
  for (std::uint32_t a = 0; a < body_count; ++a) {
    for (std::uint32_t b = a + 1; b < body_count; ++b)
      if (present(generator)) pairs.body.push_back({a, b, std::uint8_t(b % 27)});
    for (std::uint32_t w = 0; w < plane_count; ++w)
      if (present(generator)) pairs.plane.push_back({a, w});
  }
  return pairs;
}

Contacts two_laws() {
  return Contacts({{0, false, history_widths[0]},
                   {0, true, history_widths[0]},
                   {1, false, history_widths[1]},
                   {1, true, history_widths[1]}});
}

void rebuild(Contacts& contacts, const Table& table, const ListedPairs& pairs) {
  scree::ThreadPool threads(1);
  contacts.rebuild(pairs.body, pairs.plane, table.lookup(), {}, threads);
}

using Key = std::tuple<std::uint32_t, bool, std::uint32_t, std::uint32_t>;  // law, plane, a, b

// A number that identifies pair and column.
double mark(const Key& key, std::uint32_t column) {
  const auto [law, plane, a, b] = key;
  return 1 + column + 10.0 * (law + 2 * plane) + 100.0 * double(a + body_count * b);
}

template <class Visit>
void each_pair(Contacts& contacts, const Visit& visit) {
  for (PairGroup& group : contacts.groups())
    for (std::size_t p = group.begin; p < group.end; ++p)
      visit(Key(group.law, group.planes, contacts.a[p], contacts.b[p]), group, p);
}

void mark_all(Contacts& contacts) {
  each_pair(contacts, [](const Key& key, PairGroup& group, std::size_t p) {
    for (std::uint32_t k = 0; k < group.history_width; ++k)
      group.history.column(k)[p - group.begin] = mark(key, k);
  });
}

std::map<Key, std::size_t> positions(Contacts& contacts) {
  std::map<Key, std::size_t> all;
  each_pair(contacts, [&](const Key& key, PairGroup&, std::size_t p) { all[key] = p; });
  return all;
}

}  // namespace

TEST_CASE("each pair is listed once, in order, in the group of its law and kind of partner") {
  const Table table;
  Contacts contacts = two_laws();
  const ListedPairs pairs = some_pairs(0.3, 1);
  rebuild(contacts, table, pairs);

  std::size_t filed = 0;
  for (const PairGroup& group : contacts.groups()) {
    for (std::size_t p = group.begin; p < group.end; ++p, ++filed) {
      const std::uint32_t a = contacts.a[p], b = contacts.b[p];
      REQUIRE(table.law(group.planes, a, b) == group.law);
      if (p > group.begin) REQUIRE(std::tie(contacts.a[p - 1], contacts.b[p - 1]) < std::tie(a, b));
      if (group.planes)
        REQUIRE(std::any_of(pairs.plane.begin(), pairs.plane.end(),
                            [&](const PlanePair& q) { return q.body == a && q.plane == b; }));
      else
        REQUIRE(std::count(pairs.body.begin(), pairs.body.end(), NeighbourPair{a, b, contacts.image[p]}) ==
                1);
    }
  }
  CHECK(filed == pairs.body.size() + pairs.plane.size());
}

TEST_CASE("groups begin at a multiple of the lanes and are padded with pairs of their last body") {
  const Table table;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Contacts contacts = two_laws();
    rebuild(contacts, table, some_pairs(0.01 + 0.02 * seed, seed));
    std::size_t next = 0;
    for (const PairGroup& group : contacts.groups()) {
      REQUIRE(group.begin == next);
      next += group.padded_size();
      REQUIRE(group.begin % SCREE_LANES == 0);
      REQUIRE(next - group.end < SCREE_LANES);
      REQUIRE(group.history.size() == group.padded_size() * group.history_width);
      for (std::size_t p = group.end; p < next; ++p)
        REQUIRE((contacts.a[p] == contacts.a[group.end - 1] &&
                 contacts.b[p] == (group.planes ? 0 : contacts.a[p]) &&
                 contacts.image[p] == scree::Domain::no_shift));
    }
    CHECK(next == contacts.padded_size());
    CHECK(contacts.b.size() == next);
    CHECK(contacts.image.size() == next);
  }
}

TEST_CASE("pairs that remain keep their history, new ones and padding start at zero") {
  const Table table;
  Contacts contacts = two_laws();
  rebuild(contacts, table, some_pairs(0.3, 0));
  std::size_t carried = 0, fresh = 0;
  for (unsigned seed = 1; seed < 30; ++seed) {
    mark_all(contacts);
    const auto before = positions(contacts);
    // From no pairs at all to nearly all of them.
    rebuild(contacts, table, some_pairs(seed % 5 * 0.24, seed));
    each_pair(contacts, [&](const Key& key, PairGroup& group, std::size_t p) {
      const bool was = before.count(key);
      ++(was ? carried : fresh);
      for (std::uint32_t k = 0; k < group.history_width; ++k)
        REQUIRE(group.history.column(k)[p - group.begin] == (was ? mark(key, k) : 0));
    });
    for (PairGroup& group : contacts.groups())
      for (std::uint32_t k = 0; k < group.history_width; ++k)
        for (std::size_t i = group.end - group.begin; i < group.padded_size(); ++i)
          REQUIRE(group.history.column(k)[i] == 0);
  }
  CHECK(carried > 1000);
  CHECK(fresh > 1000);
}

TEST_CASE("when a law changes its history width, the common columns are kept") {
  const Table table;
  Contacts contacts = two_laws();
  const ListedPairs pairs = some_pairs(0.3, 4);
  rebuild(contacts, table, pairs);
  mark_all(contacts);
  std::uint32_t least = history_widths[0];
  for (const std::uint32_t columns : {5u, 1u, 4u, 0u, 2u}) {
    for (PairGroup& group : contacts.groups())
      if (group.law == 0) group.history_width = columns;
    rebuild(contacts, table, pairs);
    least = std::min(least, columns);
    each_pair(contacts, [&](const Key& key, PairGroup& group, std::size_t p) {
      for (std::uint32_t k = 0; k < group.history_width; ++k)
        REQUIRE(group.history.column(k)[p - group.begin] == (group.law == 1 || k < least ? mark(key, k) : 0));
    });
  }
}

// Bodies of three tiles of the usual size, numbered in another order than their places.
TEST_CASE(
    "tiles have runs of their own, pairs inside before pairs across, and histories survive a new order") {
  constexpr std::uint32_t bodies = 3 * 1024 + 100;
  const scree::BodyTiles tiles(bodies);
  REQUIRE(tiles.count() == 3);
  std::vector<std::uint32_t> numbers(bodies), material(bodies, 0);
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::mt19937 generator(2);
  std::shuffle(numbers.begin(), numbers.end(), generator);
  const std::uint32_t law_of = 0;
  const Contacts::Lookup lookup = {&law_of, 1, material.data(), material.data()};
  const auto pairs_of = [&](double distance) {
    std::vector<NeighbourPair> pairs;
    std::uniform_real_distribution<double> uniform(0, 1);
    for (std::uint32_t a = 0; a < bodies; ++a)
      for (std::uint32_t b = a + 1; b < std::min(bodies, a + 9); ++b)
        if (uniform(generator) < distance) pairs.push_back({a, b, std::uint8_t((a + b) % 27)});
    return pairs;
  };
  const auto key_of = [](std::uint32_t a, std::uint32_t b) { return double(a) * bodies + b; };
  Contacts contacts({{0, false, 1}}, tiles);
  scree::ThreadPool threads(2);
  const scree::BodyOrder order = scree::BodyOrder().moved(numbers);
  const std::vector<NeighbourPair> pairs = pairs_of(0.5);
  contacts.rebuild(pairs, {}, lookup, order, threads);
  PairGroup& group = contacts.groups()[0];
  REQUIRE(group.pairs == pairs.size());
  REQUIRE(group.runs.size() == 3);
  std::size_t next = 0, across = 0;
  for (std::size_t t = 0; t < 3; ++t) {
    const scree::PairRun& run = group.runs[t];
    REQUIRE(run.begin == next);
    next += run.padded_size();
    for (std::size_t q = run.begin; q < run.end; ++q) {
      const std::uint32_t a = contacts.a[q], b = contacts.b[q];
      REQUIRE(tiles.owner(std::min(a, b)) == t);
      REQUIRE((tiles.owner(std::max(a, b)) != t) == (q >= run.crossing));
      REQUIRE(order.number(a) < order.number(b));
      const std::uint8_t image = contacts.image[q];
      REQUIRE((a < b ? image : 26 - image) == int((a + b) % 27));
      group.history.column(0)[q - group.begin] = key_of(order.number(a), order.number(b));
      across += q >= run.crossing;
    }
  }
  REQUIRE(across > 10);
  CHECK(contacts.crossing().share() == Approx(double(across) / double(pairs.size())));

  // Half of the pairs go, others come; then each body moves to the place of its number.
  const std::vector<NeighbourPair> later = pairs_of(0.5);
  contacts.rebuild(later, {}, lookup, order, threads);
  contacts.rearrange(order.back());
  const scree::BodyOrder back = order.moved(order.back());
  CHECK(contacts.crossing().share() > 0.5);
  std::size_t kept = 0;
  const std::vector<std::size_t> listed = contacts.in_scene_order(group, back);
  REQUIRE(listed.size() == later.size());
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const std::uint32_t a = contacts.a[listed[k]], b = contacts.b[listed[k]];
    REQUIRE(a < b);
    if (k > 0) REQUIRE(std::pair(contacts.a[listed[k - 1]], contacts.b[listed[k - 1]]) < std::pair(a, b));
    const double history = group.history_of(listed[k], 0);
    REQUIRE((history == 0 || history == key_of(a, b)));
    kept += history != 0;
    const Contacts::Place found = contacts.find(false, a, b, back);
    REQUIRE(found.group == &group);
    REQUIRE(found.row == listed[k] - group.begin);
  }
  CHECK(kept > 1000);
  CHECK(kept < later.size() - 1000);
}

TEST_CASE("each pair of materials or walls has its own law") {
  // Two materials, a law with its own stiffness for each combination; overlaps of a tenth in separate pairs.
  const double radius = 1, overlap = 0.125, stiffness[] = {1000, 2000, 4000};
  std::vector<scree::Body> all;
  for (int pair = 0; pair < 3; ++pair)
    for (int side = 0; side < 2; ++side) {
      all.push_back(scree::test::body(2 * pair + side, radius, 1, {{10.0 * pair, side * (2 - overlap), 8}}));
      all.back().material = std::uint32_t(side ? pair > 0 : pair > 1);
    }
  for (std::uint32_t material = 0; material < 2; ++material) {
    all.push_back(scree::test::body(6 + material, radius, 1, {{10.0 * material, 20, 1 - overlap}}));
    all.back().material = material;
  }
  scree::Scene s =
      scree::test::scene(3, 1e-4, all, {{"normal_stiffness", {stiffness[0]}}, {"normal_damping", {0}}});
  s.materials = {"soft", "hard"};
  s.law_of = {0, 1, 1, 2};
  for (const int k : {1, 2}) {
    s.laws.push_back({"law" + std::to_string(k), s.laws[0].parameters});
    s.laws.back().parameters.set("normal_stiffness", {stiffness[k]});
  }
  scree::test::add_boundary(s, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 0, 1}}});
  s.boundaries.back().material = 1;
  const scree::Simulation simulation(s);

  // 2 − overlap and 1 − overlap are exact; the overlap of a pair has the rounding error of one root.
  const auto force = simulation.particles().force();
  for (std::size_t pair = 0; pair < 3; ++pair) {
    CHECK(force[1][2 * pair] == Approx(-stiffness[pair] * overlap).epsilon(1e-14));
    CHECK(force[1][2 * pair + 1] == -force[1][2 * pair]);
  }
  CHECK(force[2][6] == stiffness[1] * overlap);
  CHECK(force[2][7] == stiffness[2] * overlap);
  CHECK(simulation.contact_list().size() == 5);
}
