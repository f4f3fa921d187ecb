#include "backend.hpp"

#include <sys/mman.h>

#include <fmt/format.h>

#include <scree/error.hpp>
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

// Of address space (bytes): of HDF5 with the libraries that it loads, and of what it allocates beside the arrays.
constexpr std::size_t to_load = std::size_t(32) << 20, to_work = std::size_t(16) << 20;

// HDF5 crashes where memory ends while it works.
void require_memory(std::size_t bytes, const std::filesystem::path& file) {
  void* const room =
      ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED)
    throw Error(
        fmt::format("{}: there is no memory for HDF5, which writes and reads states; give the program more "
                    "(ulimit -v)",
                    file.string()),
        ExitStatus::failure);
  ::munmap(room, bytes);
}

}  // namespace

StateBackend& load_backend(const std::filesystem::path& file) {
  static StateBackend* const backend = [&] {
    require_memory(to_load, file);
    return files::load_companion<StateBackend>(library, backend_version);
  }();
  require_memory(to_work, file);
  return *backend;
}

}  // namespace scree::state_file
