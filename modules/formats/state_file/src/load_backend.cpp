#include "backend.hpp"

#include <memory>
#include <new>
#include <sys/mman.h>
#include <vector>

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

[[noreturn]] void refuse_without_memory(const std::filesystem::path& file) {
  throw Error(file.string(), "there is no memory for HDF5, which writes and reads states",
              "give the program more (ulimit -v)", ExitStatus::failure);
}

bool has_room_to_load() {
  constexpr std::size_t with_other_libraries = std::size_t(32) << 20;  // (bytes) of address space
  void* const room = ::mmap(nullptr, with_other_libraries, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return room != MAP_FAILED && ::munmap(room, with_other_libraries) == 0;
}

// HDF5 crashes if memory ends while it works. Tries small pieces, as HDF5 allocates them: where there is no
// room for a heap of the thread, each piece takes a page.
bool has_room_to_work() {
  constexpr std::size_t pieces = 16384, bytes = 256;
  try {
    std::vector<std::unique_ptr<char[]>> all(pieces);
    for (std::unique_ptr<char[]>& piece : all) piece = std::make_unique_for_overwrite<char[]>(bytes);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace

StateBackend& load_backend(const std::filesystem::path& file) {
  static StateBackend* const backend = [&] {
    if (!has_room_to_load()) refuse_without_memory(file);
    return files::load_companion<StateBackend>(library, backend_version);
  }();
  if (!has_room_to_work()) refuse_without_memory(file);
  return *backend;
}

}  // namespace scree::state_file
