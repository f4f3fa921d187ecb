#include "studies.hpp"

#include "support/study_verbs.hpp"

#include <algorithm>
#include <string_view>

#include <scree/files/companion_library.hpp>

namespace scree::tool {

bool is_study(int argc, char** argv) {
  return argc > 1 && std::any_of(study_verbs.begin(), study_verbs.end(), [&](const StudyVerb& verb) {
           return std::string_view(verb.name) == argv[1];
         });
}

ExitStatus run_study(int argc, char** argv) {
  constexpr files::CompanionLibrary library = {
      .target = "scree_studies",
      .factory = "scree_create_studies",
      .purpose = "accuracy, spectrum, cycles, modes and quasi-static",
      .without = "use other commands",
      .needs = "the run-time libraries of KLU and METIS",
      .built_on_demand = true,
  };
  return files::load_companion<Studies>(library, studies_version)->run(argc, argv);
}

}  // namespace scree::tool
