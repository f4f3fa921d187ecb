#pragma once

#include <scree/scenario/table_keys.hpp>

// The tables of a scenario and their keys: what the readers check and `scree describe` prints. Tables of
// bodies are in particles_keys.hpp, of outputs in output_keys.hpp, of studies in the modules of the studies.
namespace scree::scenario {

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
  ChoiceKey control =
      choice_or_first("control", {"present", "absent"}, "absent: bodies pass through each other; for stages");
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
  ChoiceKey control = choice_or_first("control", {"present", "absent"}, "absent: no force; for stages");
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
  UntilKeys() : TableKeys("stage.until", "until = { }", "ends a stage when conditions are met") {}
  NumberKey kinetic_over_elastic = number(
      "kinetic_over_elastic", Range::positive(),
      "kinetic energy over elastic energy below which the bodies are at rest; bodies that roll or fly on do "
      "not count",
      "optional");
  Key column = other("\"<probe>.<column>\"", "table", Range::any(), "optional",
                     "a condition on a column of a probe, see stage.until.column");
  ChoiceKey match =
      choice_or_first("match", {"all", "any"}, "whether all conditions must be met, or one of them");
  NumberKey at_least =
      number("at_least", Range::non_negative("s"), 0, "time before which the conditions are not checked");
  Key at_most = other("at_most", "number", Range::positive("s"), "required", "longest time");
  ChoiceKey otherwise = choice_or_first("otherwise", {"fail", "go_on"},
                                        "after at_most: the run fails, or the next stage begins");
};

struct UntilColumnKeys : TableKeys {
  UntilColumnKeys()
      : TableKeys(
            "stage.until.column", "\"<probe>.<column>\" = { }",
            "a condition on a column, tested at each sample of its probe; one of above, below, steady, or several") {
  }
  NumberKey above = number("above", Range::any(), "in the unit of the column", "optional");
  NumberKey below = number("below", Range::any(), "in the unit of the column", "optional");
  NumberKey steady = number("steady", Range::positive(),
                            "largest change over the largest value, within the time 'over'", "optional");
  NumberKey over =
      number("over", Range::positive("s"), "time within which it is steady", "required with steady");
};

inline const SceneKeys scene_keys;
inline const TimeKeys time_keys;
inline const StepKeys step_keys;
inline const LimitsKeys limits_keys;
inline const NeighboursKeys neighbours_keys;
inline const MaterialKeys material_keys;
inline const ContactKeys contact_keys;
inline const BoundaryKeys boundary_keys;
inline const BodyForceKeys body_force_keys;
inline const StageKeys stage_keys;
inline const UntilKeys until_keys;
inline const UntilColumnKeys until_column_keys;

}  // namespace scree::scenario
