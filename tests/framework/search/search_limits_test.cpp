#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/pair_search.hpp>

namespace {

std::size_t pairs_of(const std::vector<scree::Sphere>& bodies, int dimension) {
  scree::ThreadPool threads(1);
  return scree::PairSearch().find(bodies, dimension, {}, 0.1, threads).size();
}

}  // namespace

TEST_CASE("centres that differ by less than the smallest normal number along an axis are binned") {
  for (const double y : {5e-324, 1e-310, 1e-300}) {
    const std::vector<scree::Sphere> bodies = {{{}, 1}, {{{2.05, y, 0}}, 1}, {{{9, 0, -y}}, 1}};
    CHECK(pairs_of(bodies, 3) == 1);
    CHECK(pairs_of({bodies.begin(), bodies.begin() + 2}, 2) == 1);
  }
}

TEST_CASE("a body that is alone is refused where it would touch its own image") {
  scree::ThreadPool threads(1);
  const auto find = [&](double length) {
    const scree::Domain domain = {{true, false, false}, {}, {{length, 0, 0}}};
    scree::PairSearch().find(std::vector<scree::Sphere>{{{}, 1}}, 3, domain, 0.1, threads);
  };
  for (const double length : {1.9, 1e-300, 0.0})
    CHECK_THROWS_WITH(find(length),
                      Catch::Contains("along x is under the diameter of the body, 2 m, which would "
                                      "touch itself; give a length of at least that"));
  CHECK_NOTHROW(find(2));
}

TEST_CASE("more pairs than fit into memory are refused with the skin") {
  std::vector<scree::Sphere> bodies(3000);
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i] = {{{1e-3 * double(i), 0, 0}}, 1};
  constexpr auto unique = scree::PairSearch::Images::unique;
  for (const unsigned count : {1u, 4u}) {
    scree::ThreadPool threads(count);
    CHECK(scree::PairSearch(unique, 3000 * 2999 / 2).find(bodies, 3, {}, 10, threads).size() ==
          3000 * 2999 / 2);
    try {
      scree::PairSearch(unique, 100000).find(bodies, 3, {}, 10, threads);
      FAIL("not refused");
    } catch (const scree::Error& error) {
      CHECK_THAT(error.what(),
                 Catch::StartsWith("there are more than 1e+05 pairs of bodies nearer than the skin of "
                                   "10 m, as many as fit into ") &&
                     Catch::EndsWith("give a smaller neighbours.skin"));
    }
  }
}
