#include "studies/studies.hpp"

#include "support/program.hpp"
#include "support/study_library.hpp"

namespace scree::tool {

namespace {

class AllStudies : public Studies {
 public:
  ExitStatus run(int argc, char** argv) const override {
    return run_program(argc, argv, [](CommandLine& line) {
      add_accuracy_verb(line);
      add_spectrum_verb(line);
      add_cycles_verb(line);
      add_fields_verb(line);
      add_modes_verb(line);
      add_quasi_static_verb(line);
      add_study_resume_verb(line);
    });
  }
};

}  // namespace

}  // namespace scree::tool

extern "C" [[gnu::visibility("default")]] scree::tool::Studies* scree_create_studies(int version) {
  static scree::tool::AllStudies studies;
  return version == scree::tool::studies_version ? &studies : nullptr;
}
