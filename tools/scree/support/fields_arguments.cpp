#include "support/fields_arguments.hpp"

#include <iterator>

namespace scree::tool {

Verb add_fields_options(CommandLine& line, FieldsArguments& a) {
  Verb verb =
      line.verb("fields", "Density, momentum and stress of states as smooth fields on a grid, with balances");
  verb.option(
          "sources", a.sources,
          "States (.h5) of one run, or its directory for the last one; or frames (.vtp), or a folder snapshots")
      .required()
      .existing_path();
  verb.option("--kernel", a.kernel, "Of the averages, see the page (default triweight)")
      .one_of({std::begin(fields::kernel_names), std::end(fields::kernel_names)});
  verb.option("--width", a.width, "(m) radius of the kernel; default: two mean diameters").above_zero();
  verb.option("--spacing", a.spacing, "(m) from point to point; default: half the width").above_zero();
  verb.option("--lower", a.lower, "(m) corner of the grid; default: the bodies, or the period")
      .shown_as("X,Y,Z");
  verb.option("--upper", a.upper, "(m) opposite corner").shown_as("X,Y,Z");
  verb.option("--plane", a.plane, "A grid of one layer, such as z=0.01 (m)").shown_as("AXIS=M");
  verb.option("--out", a.out, "File .csv or .vti (ParaView); default: the name of the source, here, .csv")
      .shown_as("FILE");
  verb.option(
          "--state", a.state,
          "State (.h5) from which frames take masses, held bodies and periods; default: that of their run")
      .existing_path();
  verb.option("--density", a.density, "(kg/m^3) of all bodies of frames, instead of masses of a state")
      .above_zero();
  verb.flag("--average", a.average, "One mean of all states instead of each");
  verb.option("--threads", a.threads, "The fields have the same bits for any number").between(1, 1024);
  verb.flag("--overwrite", a.overwrite, "Replace the file");
  add_plugin_options(verb, a.plugins);
  verb.footer(
      "Several states: a .csv has them one after another; .vti files are numbered and a .pvd lists them.\n"
      "Printed: what the balances of forces in each state, of mass from state to state, and of mass and momentum\n"
      "over a step from the last state leave open, over the largest term of a body or contact.\n"
      "Columns and equations: modules/analysis/fields/README.md\n"
      "Example: scree fields runs/first/states/*.h5 --average --plane y=0.02 --out first.vti");
  return verb;
}

}  // namespace scree::tool
