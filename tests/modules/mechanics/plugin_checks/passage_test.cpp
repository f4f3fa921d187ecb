#include "passage.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::plugin_checks;

namespace {

constexpr CheckedPair pair = {.radius = 0.01, .density = 2000, .speed = 0.5};
constexpr double contact_time = 1e-3;

Vec3 vector(ContactColumns& contacts, scree_contact_input input, std::size_t i) {
  return {{contacts.input(input, 0, i), contacts.input(input, 1, i), contacts.input(input, 2, i)}};
}

}  // namespace

TEST_CASE("bodies of a passage touch for forty steps, as deep as the speed presses a spring", "[passage]") {
  const Passage passage(3, pair, contact_time);
  CHECK(passage.step() == Approx(contact_time / 40));
  ContactColumns contacts(1);
  double largest = 0;
  for (int step = 0; step < Passage::steps; ++step) {
    passage.set(contacts, 0, 2, step);
    const double overlap = contacts.input(SCREE_OVERLAP, 0, 0);
    CHECK((overlap > 0) == (step < 40));
    largest = std::max(largest, overlap);
    CHECK(norm(vector(contacts, SCREE_NORMAL, 0)) == Approx(1));
    CHECK(norm(vector(contacts, SCREE_SEPARATION, 0)) == Approx(2.5 * pair.radius - overlap));
  }
  // Steps are half a step beside the middle: 1 − cos(π/80) = 8e-4.
  CHECK(largest == Approx(pair.speed * contact_time / std::numbers::pi).epsilon(8e-4));
}

TEST_CASE("another frame turns vectors, and exchange reverses them", "[passage]") {
  const Passage passage(3, pair, contact_time);
  const Frame turned = {.exchanged = false, .angle = 0.7, .axis = {{0.6, 0, 0.8}}},
              exchanged = {.exchanged = true};
  ContactColumns contacts(3);
  passage.set(contacts, 0, 1, 13);
  passage.set(contacts, 1, 1, 13, turned);
  passage.set(contacts, 2, 1, 13, exchanged);
  for (const auto input : {SCREE_NORMAL, SCREE_SEPARATION, SCREE_RELATIVE_VELOCITY, SCREE_RELATIVE_SPIN,
                           SCREE_TANGENTIAL_INCREMENT}) {
    const Vec3 given = vector(contacts, input, 0);
    CHECK(norm(vector(contacts, input, 1) - turned(given)) < 1e-15 * norm(given) + 1e-18);
    CHECK(norm(vector(contacts, input, 2) + given) == 0);
  }
  CHECK(contacts.input(SCREE_RADII, 0, 2) == contacts.input(SCREE_RADII, 1, 0));
  CHECK(contacts.input(SCREE_ORIENTATION_B, 1, 2) == contacts.input(SCREE_ORIENTATION_A, 1, 0));
  // Frame rotates by the angle about the axis.
  CHECK(norm(turned(turned.axis) - turned.axis) < 1e-15);
  const Frame quarter = {.exchanged = false, .angle = std::numbers::pi / 2, .axis = {{0, 0, 1}}};
  CHECK(norm(quarter(Vec3{{1, 0, 0}}) - Vec3{{0, 1, 0}}) < 1e-15);
}
