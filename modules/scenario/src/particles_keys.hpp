#pragma once

#include <scree/plugin/abi.h>
#include <scree/scenario/table_keys.hpp>

namespace scree::scenario {

struct ParticlesKeys : TableKeys {
  ParticlesKeys()
      : TableKeys("particles", "[particles] or [[particles]]",
                  "bodies from a lattice, a file, a state or at random") {}
  StringKey name = string("name", "unique", "default \"particles\", \"particles_2\", ...");
  Key lattice =
      other("lattice", "table", Range::any(), "this, random, file or state", "see particles.lattice");
  Key random = other("random", "table", Range::any(), "this, lattice, file or state",
                     "bodies at random places that do not overlap, see particles.random");
  Key region =
      other("region", "table", Range::any(), "required with random",
            "bodies lie wholly in it; of a lattice or a file others are left out; see particles.region");
  NumberKey radius = number("radius", Range::positive("m"),
                            "of bodies on a lattice or at random; or a table, see particles.radius",
                            "required with lattice, random");
  StringKey file = string(
      "file",
      "CSV with a header (x, y, z, radius or diameter; also id, material, density, mass, vx, spin_x, ...; SI), "
      "a data file or dump of LAMMPS or LIGGGHTS, a .data file of MercuryDPM, or a table separated by blanks (YADE, "
      "SpherePack, named columns); relative to the scenario",
      "this, lattice, random or state");
  IntegerKey timestep =
      integer("timestep", Range::any(), "frame of a dump, or number of a frame of MercuryDPM, from 0",
              "default the last");
  Key columns =
      other("columns", "[\"x\", \"y\", \"z\", \"radius\"]", Range::any(), "default from the file",
            "of a table separated by blanks; also id, material, matId (from 0), type (from 1), diameter, "
            "density, mass, vx, spin_x, ...; \"-\" is not read");
  BooleanKey keep_ids =
      boolean("keep_ids", true, "false: bodies of a file are numbered after the largest id of the scene");
  Key repeat = other("repeat", "[nx, ny, nz]", Range::between(1, 1e4), "optional",
                     "copies of the file's bodies along each axis");
  Key period =
      other("period", "[x, y, z]", Range::positive("m"), "required with repeat", "distance of the copies");
  Key springs = other("springs", "table", Range::any(), "default none",
                      "tangential springs of the file's contacts, see particles.springs");
  StringKey state = string(
      "state",
      "state file of a run to begin from, with springs and walls; from the folder of the scenario or the working folder",
      "this, lattice, random or file");
  Key leave_out = other("leave_out", "[\"histories\", \"walls\", \"orientations\"]", Range::any(),
                        "default nothing", "what is not taken over from the state");
  StringKey material = string(
      "material", "",
      "of bodies without one in the file; or shares by number, { glass = 0.7, steel = 0.3 }, drawn at random",
      "required with several materials");
  Key velocity = other("velocity", "[x, y, z]", Range::any("m/s"), "default 0", "added to all bodies");
  Key velocity_gradient = other("velocity_gradient", "[x, y, z]", Range::any("1/s"), "default 0",
                                "times the coordinates of a body, added to its velocity");
  NumberKey random_velocity = number("random_velocity", Range::non_negative("m/s"), 0,
                                     "standard deviation of each component, added to all bodies");
};

struct SpringsKeys : TableKeys {
  SpringsKeys()
      : TableKeys("particles.springs", "springs = { }",
                  "tangential springs of contacts between bodies of the file, with which they go on") {}
  StringKey file = string(
      "file", "dump of LAMMPS or LIGGGHTS by 'dump local', of the same step; relative to the scenario");
  Key columns = other(
      "columns", "[\"a\", \"b\", \"spring_x\", ...]", Range::any(), "default from the dump",
      "ids of the bodies, and how far the contact point of a has moved relative to b's (m); \"-\" is not read");
  NumberKey factor = number("factor", Range::any(), 1.0,
                            "times the numbers of the dump gives metres: -1/k_t for tangential forces on a");
};

struct LatticeKeys : TableKeys {
  LatticeKeys() : TableKeys("particles.lattice", "lattice = { }", "a regular arrangement of bodies") {}
  Key kind = other(
      "kind", "text", Range::any(), "default the first",
      "\"simple_cubic\", \"face_centred_cubic\", \"hexagonal_close\"; in 2D \"square\", \"triangular\"");
  IntegerKey count = integer("count", Range::at_least(1), "of all bodies; or [nx, ny, nz]");
  NumberKey spacing =
      number("spacing", Range::positive("m"), "between neighbouring sites", "default from gap");
  NumberKey gap = number("gap", Range::non_negative(), 0, "between neighbours, over the largest diameter");
  NumberKey displacement =
      number("displacement", Range::non_negative("m"), 0, "largest random displacement of a body");
  Key origin = other("origin", "[x, y, z]", Range::any("m"), "default 0",
                     "lower corner of the box of the lattice, or its centre");
  BooleanKey centred = boolean("centred", false, "the origin is the centre of the box");
};

struct RandomKeys : TableKeys {
  RandomKeys()
      : TableKeys(
            "particles.random", "random = { }",
            "bodies at random places of a region, wholly in it, that overlap neither each other nor bodies of "
            "other tables; one of count, solid_fraction") {}
  IntegerKey count = integer("count", Range::at_least(1), "of bodies", "or solid_fraction");
  NumberKey solid_fraction = number(
      "solid_fraction", Range::between(0, 1),
      "volume of the bodies over volume of the region, met to rounding, since all radii are multiplied by one "
      "factor near 1; some 0.3 can be reached, in 2D 0.45, with growth 0.55 and 0.8",
      "or count");
  BooleanKey growth =
      boolean("growth", false, "bodies are placed smaller, grow together and push each other");
  StringKey periodic =
      string("periodic", "",
             "axes along which the box is periodic, such as \"xz\": bodies reach through its "
             "faces",
             "default none");
};

struct RegionKeys : TableKeys {
  RegionKeys() : TableKeys("particles.region", "region = { }", "part of space; a box has x, y and z") {}
  ChoiceKey kind = choice_or_first("kind", {"box", "sphere", "cylinder"}, "a sphere is a circle in 2D");
  Key x = other("x", "[low, high]", Range::any("m"), "required for a box", "along x");
  Key y = other("y", "[low, high]", Range::any("m"), "required for a box", "along y");
  Key z = other("z", "[low, high]", Range::any("m"), "required for a box in 3D", "along z");
  Key centre =
      other("centre", "[x, y, z]", Range::any("m"), "required for sphere, cylinder", "of the region");
  NumberKey radius = number("radius", Range::positive("m"), "of the region", "required for sphere, cylinder");
  NumberKey length = number("length", Range::positive("m"), "along the axis", "required for cylinder");
  ChoiceKey axis = choice_or_first("axis", {"z", "x", "y"}, "of a cylinder");
};

struct RadiusKeys : TableKeys {
  RadiusKeys() : TableKeys("particles.radius", "radius = { }", "a distribution of radii") {}
  ChoiceKey distribution =
      choice("distribution", {"constant", "uniform", "normal", "bidisperse", "list"}, "its kind");
  NumberKey radius = number("radius", Range::positive("m"), "of all bodies", "required for constant");
  NumberKey minimum =
      number("minimum", Range::positive("m"), "smallest radius", "required for uniform, normal");
  NumberKey maximum = number("maximum", Range::positive("m"), "largest radius",
                             "required for uniform; for normal 2 mean + 10 standard_deviation");
  NumberKey mean = number("mean", Range::positive("m"), "before truncation", "required for normal");
  NumberKey standard_deviation =
      number("standard_deviation", Range::non_negative("m"), "before truncation", "required for normal");
  NumberKey small =
      number("small", Range::positive("m"), "radius of the small bodies", "required for bidisperse");
  NumberKey large =
      number("large", Range::positive("m"), "radius of the large bodies", "required for bidisperse");
  NumberKey large_fraction = number("large_fraction", Range::between(0, 1), "number of large bodies over all",
                                    "required for bidisperse");
  Key radii = other("radii", "[r1, r2, ...]", Range::positive("m"), "required for list", "the radii");
  Key weights = other("weights", "[w1, w2, ...]", Range::non_negative(),
                      "without them the k-th body has the k-th radius",
                      "relative frequencies of the radii, drawn at random");
};

struct ParticleKeys : TableKeys {
  ParticleKeys() : TableKeys("particle", "[[particle]]", "one body") {}
  StringKey name = string("name", "unique", "default \"particle\" for all without one");
  Key position = other("position", "[x, y, z]", Range::any("m"), "required", "of its centre");
  NumberKey radius = number("radius", Range::positive("m"), "of the body");
  Key velocity = other("velocity", "[x, y, z]", Range::any("m/s"), "default 0", "at the start");
  Key spin = other("spin", "[x, y, z], in 2D a number", Range::any("rad/s"), "default 0", "at the start");
  NumberKey density =
      number("density", Range::positive("kg/m^3"), "instead of its material's", "default the material's");
  NumberKey mass =
      number("mass", Range::positive("kg"), "instead of the one by density", "default by density");
  StringKey material = string("material", "", "name of a [[material]]", "required with several materials");
  IntegerKey id = integer("id", Range::between(1, SCREE_MAX_ID), "of the body, in files and probes",
                          "default: after the largest");
};

inline const ParticlesKeys particles_keys;
inline const SpringsKeys springs_keys;
inline const LatticeKeys lattice_keys;
inline const RandomKeys random_keys;
inline const RegionKeys region_keys;
inline const RadiusKeys radius_keys;
inline const ParticleKeys particle_keys;

}  // namespace scree::scenario
