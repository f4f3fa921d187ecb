#include "column.hpp"

#include <catch2/catch.hpp>

#include <scree/response/load_response.hpp>

using namespace scree;
using namespace scree::response;
using test::column;
using test::column_discs;
using test::disc_stiffness;

// Each contact bears the whole force, so that each spring is shortened by 1/k per force.
TEST_CASE("a force on a wall is borne by each contact of a column", "[response]") {
  const Simulation simulation(column(6));  // without mass
  const std::vector<LoadResponse> responses = load_responses(simulation, {.fewest_contacts = 1});
  REQUIRE(responses.size() == 1);
  const LoadResponse& response = responses[0];
  CHECK(response.wall == 1);
  CHECK(response.residual < LoadResponse::largest_residual);
  CHECK(response.walls[0] == 0);
  CHECK(response.walls[1] == Approx((column_discs + 1) / disc_stiffness).epsilon(1e-9));
  REQUIRE(response.bodies == std::vector<std::uint32_t>{0, 1, 2});
  for (std::size_t i = 0; i < column_discs; ++i)
    CHECK(response.displacement[2 * i + 1] == Approx(-(double(i) + 1) / disc_stiffness).epsilon(1e-9));
  REQUIRE(response.contacts.size() == column_discs + 1);
  for (const LoadedContact& contact : response.contacts) {
    CHECK(contact.normal_change == Approx(1).epsilon(1e-9));
    CHECK(contact.tangential_change == Approx(0).margin(1e-9));
    CHECK_FALSE(contact.sliding);
  }
}

TEST_CASE("without a wall that forces move there is no response to a load", "[response]") {
  const Simulation simulation(column(-1));
  CHECK_THROWS_WITH(check_loaded_walls(simulation), Catch::Contains("no wall is moved by forces"));
  CHECK_THROWS_WITH(load_responses(simulation, {.fewest_contacts = 1}),
                    Catch::Contains("no wall is moved by forces"));
}

TEST_CASE("a force on a wall is borne by a fixed disc as by a floor", "[response]") {
  Scene scene = column(6);
  scene.boundaries.erase(scene.boundaries.begin());
  scene.bodies.push_back(test::body(column_discs, 1, 1, {{0, -1 + 1e-12, 0}}, {}, {}, 2));
  scene.bodies.back().fixed = true;
  const std::vector<LoadResponse> responses = load_responses(Simulation(scene), {.fewest_contacts = 1});
  REQUIRE(responses.size() == 1);
  CHECK(responses[0].walls[0] == Approx((column_discs + 1) / disc_stiffness).epsilon(1e-6));
  REQUIRE(responses[0].contacts.size() == column_discs + 1);
  for (const LoadedContact& contact : responses[0].contacts)
    CHECK(contact.normal_change == Approx(1).epsilon(1e-6));
  REQUIRE(responses[0].bodies.size() == column_discs + 1);
  CHECK(responses[0].displacement[2 * column_discs + 1] == 0);
}

// A disc between a floor, a plane that presses it, and a wheel.
TEST_CASE("a wheel that torques turn bears no tangential load", "[response][surfaces]") {
  const auto largest_change = [&](bool turns) {
    const Vec3 apart = {{1.99 * 0.8, 1.99 * 0.6, 0}};  // of the wheel, in which the disc is by 0.01
    Scene scene = test::scene(2, 1e-4, {test::body(0, 1, 1, {{0, 0.99, 0}}, {}, {}, 2)},
                              {{"normal_stiffness", {disc_stiffness}},
                               {"normal_damping", {0}},
                               {"tangential_stiffness", {600}},
                               {"tangential_damping", {0}},
                               {"friction", {0.9}}},
                              "disc_cundall_strack");
    test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "floor");
    test::add_boundary(
        scene, "plane",
        {{"point", {-0.99, 0, 0}}, {"normal", {1, 0, 0}}, {"control", {4}}, {"force", {0, 10}}}, "press");
    test::Values wheel = {{"point", {apart[0], 0.99 + apart[1], 0}}, {"radius", {1}}, {"side", {1}}};
    if (turns) wheel.insert(wheel.end(), {{"torque", {0}}, {"inertia", {1}}});
    test::add_boundary(scene, "cylinder", wheel, "wheel");
    const std::vector<LoadResponse> responses = load_responses(Simulation(scene), {.fewest_contacts = 1});
    REQUIRE(responses.size() == 1);
    double change = 0, normal = 0;
    for (const LoadedContact& contact : responses[0].contacts)
      if (contact.b == 3) change = contact.tangential_change, normal = contact.normal_change;
    CHECK(normal > 0.1);
    return std::abs(change);
  };
  CHECK(largest_change(true) < 1e-9);
  CHECK(largest_change(false) > 1e-2);
}

// A disc that slides under a paddle, which turns about a hinge as its lever becomes longer. Without friction
// the force stays along the normal, which turns with the paddle.
TEST_CASE("a smooth paddle that torques turn bears no tangential load", "[response][surfaces]") {
  Scene scene = test::scene(2, 1e-4, {test::body(0, 1, 1, {{0, 0.99, 0}}, {}, {}, 2)},
                            {{"normal_stiffness", {disc_stiffness}}, {"normal_damping", {0}}});
  test::add_boundary(scene, "plane", {{"point", {0, 0, 0}}, {"normal", {0, 1, 0}}}, "floor");
  test::add_boundary(scene, "plane", {{"point", {0.99, 0, 0}}, {"normal", {-1, 0, 0}}}, "stop");
  test::add_boundary(scene, "plane",
                     {{"point", {-0.99, 0, 0}}, {"normal", {1, 0, 0}}, {"control", {4}}, {"force", {0, 10}}},
                     "press");
  test::add_boundary(scene, "rectangle",
                     {{"point", {0, 1.98, 0}},
                      {"normal", {0, -1, 0}},
                      {"length", {8}},
                      {"torque", {-30}},
                      {"inertia", {1}},
                      {"spin_point", {-3, 1.98, 0}}},
                     "paddle");
  const std::vector<LoadResponse> responses = load_responses(Simulation(scene), {.fewest_contacts = 1});
  REQUIRE(responses.size() == 1);
  bool found = false;
  for (const LoadedContact& contact : responses[0].contacts) {
    CHECK(std::abs(contact.tangential_change) < 1e-9);
    if (contact.b != 4) continue;
    found = true;
    // The lever of 3 m grows by dx = 1/k, less 0.99 m times the turn φ = 2 dF/(3 k); 10 N φ push the disc
    // too, 2e-5 of the load.
    CHECK(contact.normal_change ==
          Approx(-10.0 / 3 / disc_stiffness / (1 + 2 * 0.99 * 10 / (9 * disc_stiffness))).epsilon(1e-4));
  }
  CHECK(found);
}
