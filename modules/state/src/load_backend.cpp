#include "backend.hpp"

#include <scree/files/companion_library.hpp>

namespace scree::state_file {
namespace {

constexpr files::CompanionLibrary library = {
    .target = "scree_state_hdf5",
    .factory = "scree_create_state_backend",
    .purpose = "states",
    .without = "neither write nor read them",
    .needs = "the HDF5 run-time library",
};

}  // namespace

StateBackend& load_backend() {
  static StateBackend* const backend = files::load_companion<StateBackend>(library, backend_version);
  return *backend;
}

}  // namespace scree::state_file
