#pragma once

#include <scree/charts/draw_chart.hpp>
#include <scree/fields/averaging_kernel.hpp>
#include <scree/pictures/render_options.hpp>
#include <scree/scenario/table_keys.hpp>

namespace scree::scenario {

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
  Key groups = other("groups", "[\"name\", ...]", Range::any(), "default all bodies",
                     "groups whose bodies it counts; refused by probes of walls and of the energy balance");
  Key leave_out = other("leave_out", "[\"name\", ...]", Range::any(), "default none",
                        "groups whose bodies these do not count");
};

struct DerivedKeys : TableKeys {
  DerivedKeys()
      : TableKeys(
            "derived", "[derived]",
            "formulas of columns: K0 = \"box.stress_xx / box.stress_zz\", or K0 = a table of these keys; "
            "series/derived.csv") {}
  StringKey formula = string(
      "formula",
      "numbers, pi, time, <probe>.<column>, derived.<name> of what stands above; + - * / ^ ( ); sqrt, abs, "
      "exp, log, log10, sin, cos, tan, asin, acos, atan, min(a, b), max(a, b); 1/0 is inf, 0/0 nan; names "
      "with other characters than letters, digits and _ stand in '...'");
  StringKey unit = string("unit", "of the result", "default by those of the columns");
  Key every =
      other("every", "number", Range::positive("s"), "default the longest of the probes that it reads",
            "time between samples; the series has the smallest of its quantities");
};

struct ChartKeys : TableKeys {
  ChartKeys() : TableKeys("chart", "[[chart]]", "curves of columns of a probe, charts/<name>.<format>") {}
  StringKey name = string("name", "of the file");
  StringKey probe =
      string("probe", "name of a [[probe]], or derived", "required unless y is <probe>.<column>");
  StringKey x = string("x", "time", "column", "default \"time\"");
  Key y = other("y", "text or [text, ...]", Range::any(), "this or profile", "columns, a curve each");
  StringKey profile =
      string("profile", "name of numbered columns without their number, drawn over the bins", "this or y");
  Key profile_range = other("profile_range", "[low, high]", Range::any(), "default the numbers of the bins",
                            "x at the outer ends of the first and the last bin");
  StringKey profile_unit = string("profile_unit", "", "of profile_range", "default none");
  IntegerKey profile_curves = integer("profile_curves", Range::between(1, 20), 1,
                                      "times for which the profile is drawn, the last at the end");
  StringKey title = string("title", "above the chart", "default the name");
  StringKey x_label =
      string("x_label", "of the axis; its unit is added unless the label ends with it or has brackets",
             "default the column");
  StringKey y_label =
      string("y_label", "of the axis; its unit is added unless the label ends with it or has brackets",
             "default the column, of several the quantity");
  BooleanKey log_x =
      boolean("log_x", false, "logarithmic axis; points without a logarithm are left out and counted");
  BooleanKey log_y =
      boolean("log_y", false, "logarithmic axis; points without a logarithm are left out and counted");
  ChoiceKey format = choice_or_first("format", {charts::chart_formats.begin(), charts::chart_formats.end()},
                                     "pixels, or curves and letters of any size");
};

struct SnapshotKeys : TableKeys {
  SnapshotKeys()
      : TableKeys("snapshot", "[snapshot]", "files for ParaView and pictures of the whole scene") {}
  Key every = other("every", "number", Range::positive("s"), "default never", "time between .vtp files");
  BooleanKey sliding_work =
      boolean("sliding_work", false,
              "surfaces_<step>.vtp have the energy per area that friction has dissipated on each facet of "
              "cylinders, meshes and other surfaces since the start of the run");
  BooleanKey h5md = boolean("h5md", false, "the bodies of the same times in one file too, trajectory.h5md");
  Key image_every = other("image_every", "number", Range::positive("s"), "default never",
                          "time between pictures, from the start of each stage; each stage ends with one");
  BooleanKey film =
      boolean("film", false, "join the pictures to film.mp4 at the end, with the program ffmpeg");
  IntegerKey film_rate_hz =
      integer("film_rate_hz", Range::between(1, 240, "Hz"), 25, "pictures per second of the film");
  ChoiceKey color_by =
      choice_or_first("color_by", {pictures::color_fields.begin(), pictures::color_fields.end()},
                      "quantity that colours bodies");
  ChoiceKey color_surfaces_by = choice_or_first(
      "color_surfaces_by", {pictures::surface_maps_shown.begin(), pictures::surface_maps_shown.end()},
      "map on the facets of cylinders, meshes and other surfaces; the last with sliding_work = true");
  Key color_range = other("color_range", "[low, high]", Range::any(), "default that of the pictures so far",
                          "values (SI) at the ends of the colour bar");
  Key view = other("view", "\"iso\", \"x\", \"y\", \"z\" or [x, y, z]", Range::any(),
                   "default \"iso\", in 2D along z",
                   "direction of view; a vector points from the scene to the viewer");
  Key contacts =
      other("contacts", "true, false or \"strong\"", Range::any(), "default false",
            "draw forces of contacts as tubes; strong: those above the mean alone, coloured by force");
  BooleanKey bodies = boolean("bodies", true, "draw the bodies");
  BooleanKey shadows = boolean("shadows", false, "darken the hollows between bodies, in 3D");
  BooleanKey title = boolean("title", true, "write the title of the scene");
  BooleanKey time = boolean("time", true, "write the time");
  BooleanKey scale_bar = boolean("scale_bar", false, "draw a bar of a round length");
  BooleanKey follow_bodies =
      boolean("follow_bodies", false, "the frame holds the bodies of each picture, not all walls");
  Key cut =
      other("cut", "table", Range::any(), "default all", "part of the scene that is drawn, see snapshot.cut");
  IntegerKey width = integer("width", Range::between(200, 8000, "pixels"), 1200, "of a picture");
  IntegerKey height = integer("height", Range::between(200, 8000, "pixels"), 900, "of a picture");
};

struct CutKeys : TableKeys {
  CutKeys()
      : TableKeys(
            "snapshot.cut", "cut = { }",
            "what lies between the ends along each axis is drawn, a slice or a half; bodies are cut there and show "
            "their inside") {}
  Key x = other("x", "[low, high]", Range::any("m"), "default all", "along x");
  Key y = other("y", "[low, high]", Range::any("m"), "default all", "along y");
  Key z = other("z", "[low, high]", Range::any("m"), "default all", "along z");
};

struct FieldsKeys : TableKeys {
  FieldsKeys()
      : TableKeys(
            "fields", "[[fields]]",
            "density, momentum and stress on a grid at times of the run, as scree fields computes them of "
            "states; fields/<name>.pvd or .csv") {}
  Key every = other("every", "number", Range::positive("s"), "required", "time between them");
  StringKey name = string("name", "fields", "of the files", "default \"fields\"");
  ChoiceKey format =
      choice_or_first("format", {"vti", "csv"}, "a file for ParaView of each time, or one table of all");
  Key stages =
      other("stages", "[\"name\", ...]", Range::any(), "default all", "stages in which it is computed");
  ChoiceKey kernel = choice_or_first(
      "kernel", {std::begin(fields::kernel_names), std::end(fields::kernel_names)}, "of the averages");
  NumberKey width = number("width", Range::positive("m"), "radius of the kernel",
                           "default two mean diameters at the start");
  NumberKey spacing =
      number("spacing", Range::positive("m"), "from point to point", "default half the width");
  Key lower = other("lower", "[x, y, z]", Range::any("m"), "default the bodies at the start, or the period",
                    "corner of the grid");
  Key upper = other("upper", "[x, y, z]", Range::any("m"), "default the bodies at the start, or the period",
                    "opposite corner");
  Key plane = other("plane", "table", Range::any(), "default none",
                    "a grid of one layer: { x = m }, { y = m } or { z = m }");
};

struct CheckpointKeys : TableKeys {
  CheckpointKeys()
      : TableKeys(
            "checkpoint", "[checkpoint]",
            "states from which scree resume goes on: the two latest of a run in checkpoint/, the latest of a "
            "study in state.h5") {}
  StringKey every =
      string("every", "10 min", "wall time between them, as \"30 s\", \"10 min\", \"2 h\" or \"never\"",
             "default \"10 min\"");
  Key every_time =
      other("every_time", "number", Range::positive("s"), "default never", "simulated time between them");
  BooleanKey final_state = boolean("final_state", true, "leave the state at the end in final_state.h5");
  BooleanKey stage_states = boolean(
      "stage_states", true, "leave the state at the end of each stage but the last in states/<stage>.h5");
};

struct ExpectKeys : TableKeys {
  ExpectKeys()
      : TableKeys("expect", "[[expect]]",
                  "a condition that the result must fulfil; reference and tolerance, at_most, or at_least") {}
  StringKey requirement = string("requirement", "a sentence for the report");
  StringKey quantity = string(
      "quantity",
      "a number of run.json, <probe>.<column>.<last, first, min, max, mean or last_number>, where the last passes over NaN, or of scree spectrum "
      "peaks.<method>.<probe>.<column>.<peak_1, ... or 3lambda/4, ...>.<frequency, quality or amplitude>");
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

inline const ProbeKeys probe_keys;
inline const DerivedKeys derived_keys;
inline const ChartKeys chart_keys;
inline const SnapshotKeys snapshot_keys;
inline const CutKeys cut_keys;
inline const FieldsKeys fields_keys;
inline const CheckpointKeys checkpoint_keys;
inline const ExpectKeys expect_keys;

}  // namespace scree::scenario
