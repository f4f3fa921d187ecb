#include "packing_support.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include <scree/packing/import.hpp>
#include <scree/packing/lammps.hpp>

using namespace scree::packing;
using Catch::Matchers::Contains;

namespace {

// A data file does not contain these.
ImportOptions options_like(const Packing& packing) {
  return {.dimension = packing.dimension, .periodic = packing.periodic};
}

}  // namespace

TEST_CASE("a data file keeps every bit", "[packing]") {
  Packing packing = awkward_packing(3);
  packing.time = 0.0;
  CHECK(same_bits(parse_lammps_data(format_lammps_data(packing), "d", options_like(packing)), packing));
}

TEST_CASE("a data file in two dimensions keeps every bit but the mass, which is of spheres there",
          "[packing]") {
  Packing packing = awkward_packing(2);
  packing.time = 0.0;
  for (std::size_t i = 0; i < packing.bodies.size(); i += 2) {
    packing.bodies[i].mass = 3.0 + double(i);
    packing.bodies[i].density = unset;
  }
  Packing back = parse_lammps_data(format_lammps_data(packing), "d", options_like(packing));
  for (std::size_t i = 0; i < packing.bodies.size(); ++i) {
    Body& body = packing.bodies[i];
    const double disc = std::numbers::pi * body.radius * body.radius * body.density;
    CHECK(back.bodies[i].mass == Approx(std::isnan(body.mass) ? disc : body.mass).epsilon(1e-14));
    body.mass = back.bodies[i].mass;
    body.density = unset;
  }
  CHECK(same_bits(back, packing));
}

TEST_CASE("a data file is written, recognised and read", "[packing]") {
  const auto path = std::filesystem::temp_directory_path() / "scree_packing_data_test.data";
  Packing packing = awkward_packing(3);
  packing.time = 0.0;
  write_lammps_data(packing, path);
  CHECK(same_bits(read_packing(path, options_like(packing)), packing));
  std::filesystem::remove(path);
}

TEST_CASE("an exported body without density gets that of the options, one with a mass that of a sphere",
          "[packing]") {
  Packing packing = awkward_packing(3, 3);
  packing.bodies[0].density = unset;
  packing.bodies[1].density = unset;
  packing.bodies[1].radius = 0.5;
  packing.bodies[1].mass = 3.0;
  CHECK_THAT(error_of([&] { format_lammps_data(packing); }), Contains("body 9 has no density; "));
  const Packing read = parse_lammps_data(format_lammps_data(packing, {.density = 1000.0}), "d");
  CHECK(read.bodies[0].density == 1000.0);
  CHECK(read.bodies[1].density == Approx(3.0 / (3.14159265358979 / 6.0)).epsilon(1e-12));
}

TEST_CASE("a body that LAMMPS or LIGGGHTS would lose is not exported", "[packing]") {
  Packing packing = awkward_packing(3, 3);
  packing.bodies[1].position = {{0.0, packing.bounds->upper[1], 0.0}};
  CHECK_THAT(error_of([&] { format_lammps_data(packing); }),
             Contains("body 6 lies at y = ") && Contains("widen"));
  packing.bodies[1].position = {{0.0, packing.bounds->lower[1], 0.0}};
  CHECK(error_of([&] { format_lammps_data(packing); }).empty());
  packing.bounds.reset();
  packing.periodic = {};
  CHECK(error_of([&] { format_lammps_data(packing); }).empty());
}
