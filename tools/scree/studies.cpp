#include "studies.hpp"

#include "support/accuracy_arguments.hpp"
#include "support/cycles_arguments.hpp"
#include "support/fields_arguments.hpp"
#include "support/modes_arguments.hpp"
#include "support/quasi_static_arguments.hpp"
#include "support/spectrum_arguments.hpp"
#include "support/study_library.hpp"

#include <memory>

#include <scree/files/companion_library.hpp>

namespace scree::tool {

namespace {

// The verb with its options, which the library reads again.
template <class Arguments>
void add(CommandLine& line, Verb (*add_options)(CommandLine&, Arguments&),
         const std::function<ExitStatus()>& do_study) {
  const auto arguments = std::make_shared<Arguments>();
  add_options(line, *arguments).action([arguments, do_study] { return do_study(); });
}

}  // namespace

void add_study_verbs(CommandLine& line, const std::function<ExitStatus()>& do_study) {
  add(line, add_accuracy_options, do_study);
  add(line, add_spectrum_options, do_study);
  add(line, add_cycles_options, do_study);
  add(line, add_fields_options, do_study);
  add(line, add_modes_options, do_study);
  add(line, add_quasi_static_options, do_study);
}

ExitStatus run_study(int argc, char** argv) {
  constexpr files::CompanionLibrary library = {
      .target = "scree_studies",
      .factory = "scree_create_studies",
      .purpose = "accuracy, spectrum, cycles, fields, modes and quasi-static",
      .without = "use other commands",
      .needs = "the run-time libraries of KLU and METIS",
      .built_on_demand = true,
  };
  return files::load_companion<Studies>(library, studies_version)->run(argc, argv);
}

}  // namespace scree::tool
