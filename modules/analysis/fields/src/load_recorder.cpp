#include <scree/fields/field_recorder.hpp>
#include <scree/files/companion_library.hpp>

namespace scree::fields {

FieldRecorder& load_recorder() {
  static FieldRecorder* const recorder = files::load_companion<FieldRecorder>(
      {
          .target = "scree_field_recorder",
          .factory = "scree_create_field_recorder",
          .purpose = "[[fields]]",
          .without = "leave them out (--set 'fields=[]')",
          .needs = "the library again with this program",
          .built_on_demand = true,
      },
      recorder_version);
  return *recorder;
}

}  // namespace scree::fields
