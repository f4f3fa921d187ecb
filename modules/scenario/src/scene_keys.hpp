#pragma once

#include "table_keys.hpp"

#include <scree/integration.hpp>
#include <scree/plugin/abi.h>
#include <scree/snapshot/render_options.hpp>

// The tables of a scenario and their keys: what the readers check and `scree describe` prints.
namespace scree::scenario {

using document::Range;

std::vector<std::string> integrator_names();

struct SceneKeys : TableKeys {
  SceneKeys() : TableKeys("scene", "[scene]", "title, dimension and seed") {}
  StringKey title = string("title", "", "title of pictures and reports", "default none");
  IntegerKey dimension = integer("dimension", Range::between(2, 3), 3, "discs of 1 m depth, or spheres");
  IntegerKey seed =
      integer("seed", Range::non_negative(), 1, "of all random numbers; the same seed gives the same bits");
};

struct TimeKeys : TableKeys {
  TimeKeys() : TableKeys("time", "[time]", "time step and integration") {}
  NumberKey step = number("step", Range::positive("s"),
                          "length of a step; or { fraction = 0.02 } of the shortest contact");
  Key duration = other("duration", "number", Range::positive("s"),
                       "required without [[stage]], not allowed with it", "of the run");
  ChoiceKey integrator = choice_or_first("integrator", integrator_names(), "scheme; see scree accuracy");
  ChoiceKey precision =
      choice_or_first("precision", {"double", "mixed"}, "mixed evaluates contacts in float");
  NumberKey expected_speed =
      number("expected_speed", Range::positive("m/s"), "speed of impacts at which the step is judged",
             "default twice the fastest body's at the start, at least 1 m/s");
  BooleanKey step_guard = boolean("step_guard", true, "refuse a step that is too long for the scene");
  BooleanKey energy_audit = boolean("energy_audit", true, "keep the energy balance");
};

struct StepKeys : TableKeys {
  StepKeys() : TableKeys("time.step", "step = { }", "a step from the shortest contact") {}
  NumberKey fraction =
      number("fraction", Range::positive(), "of the shortest contact time of any law and pair");
};

struct LimitsKeys : TableKeys {
  LimitsKeys() : TableKeys("limits", "[limits]", "a run that exceeds them is stopped as unstable") {}
  NumberKey overlap_ratio =
      number("overlap_ratio", Range::positive(), 0.5, "overlap over the smaller radius");
  NumberKey speed =
      number("speed", Range::positive("m/s"), "of any body", "default one smallest radius per step");
};

struct NeighboursKeys : TableKeys {
  NeighboursKeys() : TableKeys("neighbours", "[neighbours]", "neighbour search; affects speed only") {}
  NumberKey skin = number("skin", Range::positive("m"), "gap up to which pairs are listed",
                          "default the one that makes steps cheapest, adapted while the scene moves");
};

struct ParticlesKeys : TableKeys {
  ParticlesKeys() : TableKeys("particles", "[particles]", "bodies from a lattice or a file") {}
  Key lattice = other("lattice", "table", Range::any(), "this or file", "see particles.lattice");
  NumberKey radius =
      number("radius", Range::positive("m"), "of bodies on a lattice; or a table, see particles.radius",
             "required with lattice");
  StringKey file =
      string("file", "CSV, or a data file or dump of LAMMPS or LIGGGHTS; relative to the scenario",
             "this, state or lattice");
  IntegerKey timestep = integer("timestep", Range::any(), "frame of a dump", "default the last");
  Key repeat = other("repeat", "[nx, ny, nz]", Range::between(1, 1e4), "optional",
                     "copies of the file's bodies along each axis");
  Key period =
      other("period", "[x, y, z]", Range::positive("m"), "required with repeat", "distance of the copies");
  StringKey state = string(
      "state",
      "state file of a run to begin from, with springs and walls; from the folder of the scenario or the working folder",
      "instead of lattice and file");
  Key leave_out = other("leave_out", "[\"histories\", \"walls\", \"orientations\"]", Range::any(),
                        "default nothing", "what is not taken over from the state");
  StringKey material =
      string("material", "", "of bodies without one in the file", "required with several materials");
  Key velocity = other("velocity", "[x, y, z]", Range::any("m/s"), "default 0", "added to all bodies");
  Key velocity_gradient = other("velocity_gradient", "[x, y, z]", Range::any("1/s"), "default 0",
                                "times the coordinates of a body, added to its velocity");
  NumberKey random_velocity = number("random_velocity", Range::non_negative("m/s"), 0,
                                     "standard deviation of each component, added to all bodies");
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
  Key position = other("position", "[x, y, z]", Range::any("m"), "required", "of its centre");
  NumberKey radius = number("radius", Range::positive("m"), "of the body");
  Key velocity = other("velocity", "[x, y, z]", Range::any("m/s"), "default 0", "at the start");
  Key spin = other("spin", "[x, y, z], in 2D a number", Range::any("rad/s"), "default 0", "at the start");
  NumberKey density =
      number("density", Range::positive("kg/m^3"), "instead of its material's", "default the material's");
  NumberKey mass =
      number("mass", Range::positive("kg"), "instead of the one by density", "default by density");
  StringKey material = string("material", "", "name of a [[material]]", "required with several materials");
  IntegerKey id = integer("id", Range::between(1, SCREE_MAX_ID), 0,
                          "of the body, in files and probes; without it numbered after the largest");
};

struct MaterialKeys : TableKeys {
  MaterialKeys() : TableKeys("material", "[[material]]", "a material of bodies and walls") {}
  StringKey name = string("name", "unique");
  NumberKey density = number("density", Range::positive("kg/m^3"), "of bodies");
};

struct ContactKeys : TableKeys {
  ContactKeys()
      : TableKeys("contact", "[[contact]]", "a contact law; beside these the parameters of its plug-in") {}
  StringKey plugin = string("plugin", "of kind contact");
  StringKey name = string("name", "for stages and messages", "default the plug-in's");
  Key between = other("between", "[\"a\", \"b\"]", Range::any(),
                      "default all pairs without a law of their own", "two materials");
};

struct BoundaryKeys : TableKeys {
  BoundaryKeys()
      : TableKeys("boundary", "[[boundary]]",
                  "walls or periodic faces; beside these the parameters of the plug-in") {}
  StringKey plugin = string("plugin", "of kind boundary");
  StringKey name = string("name", "for stages, probes and messages", "default the plug-in's");
  StringKey material = string("material", "name of a [[material]]", "required with several materials");
};

struct BodyForceKeys : TableKeys {
  BodyForceKeys()
      : TableKeys("body_force", "[[body_force]]",
                  "a force on every body; beside these the parameters of the plug-in") {}
  StringKey plugin = string("plugin", "of kind body_force");
  StringKey name = string("name", "for stages and messages", "default the plug-in's");
};

struct StageKeys : TableKeys {
  StageKeys() : TableKeys("stage", "[[stage]]", "a part of the run; one of duration, cycles, until") {}
  StringKey name = string("name", "unique", "default \"stage 1\", ...");
  Key duration = other("duration", "number", Range::positive("s"), "or cycles, or until", "of the stage");
  NumberKey cycles = number("cycles", Range::positive(), "number of periods", "or duration, or until");
  Key period = other("period", "number", Range::positive("s"), "required with cycles", "of a cycle");
  Key until = other("until", "table", Range::any(), "or duration, or cycles", "a condition, see stage.until");
  Key set = other("set", "set.<name>.<parameter>", Range::any(), "optional",
                  "new parameters of a contact law, boundary or body force from here on");
};

struct UntilKeys : TableKeys {
  UntilKeys() : TableKeys("stage.until", "until = { }", "ends a stage when the bodies have come to rest") {}
  NumberKey kinetic_over_elastic = number("kinetic_over_elastic", Range::positive(),
                                          "kinetic energy over elastic energy below which the stage ends");
  NumberKey at_least =
      number("at_least", Range::non_negative("s"), 0, "time before which the condition is not checked");
  Key at_most =
      other("at_most", "number", Range::positive("s"), "required", "time after which the run fails");
};

struct ProbeKeys : TableKeys {
  ProbeKeys()
      : TableKeys("probe", "[[probe]]",
                  "a time series, series/<name>.csv; beside these the parameters of the plug-in") {}
  StringKey plugin = string("plugin", "of kind probe");
  Key every = other("every", "number", Range::positive("s"), "required with stages", "time between samples");
  Key observe_every = other("observe_every", "number", Range::positive("s"), "default every step",
                            "time between updates of what the probe keeps, if it observes the run");
  Key stages = other("stages", "[\"name\", ...]", Range::any(), "default all", "stages in which it records");
  StringKey name = string("name", "of the file", "default the plug-in's");
};

struct ChartKeys : TableKeys {
  ChartKeys() : TableKeys("chart", "[[chart]]", "a picture of columns of a probe, charts/<name>.png") {}
  StringKey name = string("name", "of the file");
  StringKey probe = string("probe", "name of a [[probe]]");
  StringKey x = string("x", "time", "column", "default \"time\"");
  Key y = other("y", "text or [text, ...]", Range::any(), "required", "columns, a curve each");
  StringKey title = string("title", "above the chart", "default the name");
  StringKey x_label = string("x_label", "of the axis", "default column and unit");
  StringKey y_label = string("y_label", "of the axis", "default column and unit");
  BooleanKey log_x = boolean("log_x", false, "logarithmic axis");
  BooleanKey log_y = boolean("log_y", false, "logarithmic axis");
};

struct SnapshotKeys : TableKeys {
  SnapshotKeys()
      : TableKeys("snapshot", "[snapshot]", "files for ParaView and pictures of the whole scene") {}
  Key every = other("every", "number", Range::positive("s"), "default never", "time between .vtp files");
  Key image_every =
      other("image_every", "number", Range::positive("s"), "default never", "time between pictures");
  ChoiceKey color_by =
      choice_or_first("color_by", {snapshot::color_fields.begin(), snapshot::color_fields.end()},
                      "quantity that colours bodies");
  Key color_range = other("color_range", "[low, high]", Range::any(), "default that of the pictures so far",
                          "values (SI) at the ends of the colour bar");
  ChoiceKey view = choice("view", {snapshot::view_names.begin(), snapshot::view_names.end()},
                          "direction of view", "default \"iso\", in 2D along z");
  BooleanKey contacts = boolean("contacts", false, "draw forces of contacts as tubes");
  IntegerKey width = integer("width", Range::between(200, 8000, "pixels"), 1200, "of a picture");
  IntegerKey height = integer("height", Range::between(200, 8000, "pixels"), 900, "of a picture");
};

struct CheckpointKeys : TableKeys {
  CheckpointKeys()
      : TableKeys("checkpoint", "[checkpoint]",
                  "states from which scree resume goes on; the two latest are kept in checkpoint/") {}
  StringKey every =
      string("every", "10 min", "wall time between them, as \"30 s\", \"10 min\", \"2 h\" or \"never\"",
             "default \"10 min\"");
  Key every_time =
      other("every_time", "number", Range::positive("s"), "default never", "simulated time between them");
  BooleanKey final_state = boolean("final_state", true, "leave the state at the end in final_state.h5");
};

struct ExpectKeys : TableKeys {
  ExpectKeys()
      : TableKeys("expect", "[[expect]]",
                  "a condition that the result must fulfil; reference and tolerance, at_most, or at_least") {}
  StringKey requirement = string("requirement", "a sentence for the report");
  StringKey quantity =
      string("quantity", "a number of run.json, or <probe>.<column>.<last, first, min, max or mean>");
  NumberKey reference = number("reference", Range::any(), "expected value", "optional");
  NumberKey tolerance =
      number("tolerance", Range::non_negative(), "largest deviation from it", "required with reference");
  NumberKey at_most = number("at_most", Range::any(), "upper bound", "optional");
  NumberKey at_least = number("at_least", Range::any(), "lower bound", "optional");
  BooleanKey of_step =
      boolean("of_step", false, "the reference holds for the step of the file alone (scree accuracy)");
  NumberKey scale = number("scale", Range::positive(), "what errors are divided by (scree accuracy)",
                           "default |reference|");
};

struct SpectrumKeys : TableKeys {
  SpectrumKeys()
      : TableKeys(
            "spectrum", "[spectrum]",
            "the response to a driven wall over frequency, for scree spectrum; stages, if any, run first") {}
  StringKey drive =
      string("drive", "boundary and its displacement, as \"top.displacement\", that takes the wave");
  NumberKey amplitude = number("amplitude", Range::positive("m"), "of the wave");
  Key observe = other("observe", "[\"probe.column\", ...]", Range::any(), "required", "columns that respond");
  Key relative_to_mean =
      other("relative_to_mean", "[\"probe.column\", ...]", Range::any(), "default none",
            "columns that are divided by their means, such as the distance of two layers for a strain");
  StringKey shape_from =
      string("shape_from",
             "probe whose columns displacement_1, ... give the shapes and names of peaks, such as a profile",
             "default none");
  NumberKey from_hz = number("from_hz", Range::positive("Hz"), "lowest frequency");
  NumberKey to_hz = number("to_hz", Range::positive("Hz"), "highest frequency");
  NumberKey step_hz = number("step_hz", Range::positive("Hz"), "distance of frequencies");
  ChoiceKey direction = choice_or_first("direction", {"up", "down", "both"}, "of a sweep");
  NumberKey periods = number("periods", Range::at_least(3), 100, "of a sweep at each frequency");
  NumberKey analysed_periods = number("analysed_periods", Range::at_least(2), 60,
                                      "of these, the last ones, from which amplitudes follow");
  NumberKey samples_per_period =
      number("samples_per_period", Range::between(4, 1e4), 50, "of a sweep and, at to_hz, of a pulse");
  NumberKey rise_periods = number("rise_periods", Range::non_negative(), 5,
                                  "of the first frequency, in which a sweep rises smoothly");
  ChoiceKey detrend =
      choice_or_first("detrend", {"period_average", "polynomial"}, "what is done against drift in a sweep");
  BooleanKey adaptive = boolean(
      "adaptive", false,
      "a sweep stays at each frequency until the response is steady, and takes the grid in full only where it varies");
  NumberKey tolerance = number(
      "tolerance", Range::between(1e-9, 0.1), 1e-3,
      "relative error of the linear response of more than 300 degrees of freedom, and of the response that an adaptive sweep takes to be steady");
  ChoiceKey pulse =
      choice_or_first("pulse", {"gaussian", "ricker"}, "wave of a pulse, as wide as to_hz needs");
  NumberKey decay =
      number("decay", Range::between(1e-12, 0.5), 1e-4,
             "integral of the response to a pulse behind its record, over that before: below it the "
             "response has decayed");
  NumberKey longest_pulse = number("longest_pulse", Range::positive("s"),
                                   "after which the record of a pulse ends anyway", "default 30 / step_hz");
  IntegerKey fewest_contacts =
      integer("fewest_contacts", Range::at_least(1), "that hold a body in the linear response",
              "default 2, and one more than dimensions without tangential forces");
};

inline const SceneKeys scene_keys;
inline const TimeKeys time_keys;
inline const StepKeys step_keys;
inline const LimitsKeys limits_keys;
inline const NeighboursKeys neighbours_keys;
inline const ParticlesKeys particles_keys;
inline const LatticeKeys lattice_keys;
inline const RadiusKeys radius_keys;
inline const ParticleKeys particle_keys;
inline const MaterialKeys material_keys;
inline const ContactKeys contact_keys;
inline const BoundaryKeys boundary_keys;
inline const BodyForceKeys body_force_keys;
inline const StageKeys stage_keys;
inline const UntilKeys until_keys;
inline const ProbeKeys probe_keys;
inline const ChartKeys chart_keys;
inline const SnapshotKeys snapshot_keys;
inline const CheckpointKeys checkpoint_keys;
inline const ExpectKeys expect_keys;
inline const SpectrumKeys spectrum_keys;

}  // namespace scree::scenario
