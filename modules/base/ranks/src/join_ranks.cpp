#include "backend.hpp"

#include <scree/error.hpp>
#include <scree/files/companion_library.hpp>
#include <scree/ranks/join_ranks.hpp>

namespace scree::ranks {
namespace {

constexpr files::CompanionLibrary library = {
    .target = "scree_ranks_mpi",
    .factory = "scree_create_ranks_backend",
    .purpose = "several processes",
    .without = "use one process",
    .needs = "the MPI run-time library (apt install libopenmpi3)",
};

}  // namespace

bool has_mpi() { return SCREE_MPI; }

std::unique_ptr<Ranks> join_ranks(std::size_t piece) {
  // A library from an earlier build with MPI may still be there.
  if (!has_mpi())
    throw Error("", "this program was built without MPI, which is required for several processes",
                "install libopenmpi-dev, configure and build again", ExitStatus::failure);
  static RanksBackend* const backend = files::load_companion<RanksBackend>(library, backend_version);
  return backend->join(piece);
}

}  // namespace scree::ranks
