#include <array>
#include <dlfcn.h>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/snapshot/load_backend.hpp>

namespace scree::snapshot {
namespace {

constexpr const char* library_name = "libscree_snapshot_vtk.so";
constexpr const char* factory_name = "scree_create_snapshot_backend";

std::filesystem::path find_library() {
  const std::filesystem::path prefix =
      std::filesystem::canonical("/proc/self/exe").parent_path().parent_path();
  const std::array candidates = {prefix / "lib", prefix / "lib" / "scree",
                                 prefix / SCREE_INSTALL_LIBRARY_DIRECTORY / "scree"};
  for (const auto& directory : candidates)
    if (std::filesystem::exists(directory / library_name)) return directory / library_name;
  throw Error(
      fmt::format("{}/{}: not found; it is required for snapshots, images and charts: build the target "
                  "scree_snapshot_vtk, or leave them out",
                  candidates[0].string(), library_name));
}

std::shared_ptr<SnapshotBackend> load_once() {
  // A library from an earlier build with pictures may still be there.
  if (!has_pictures()) throw Error(fmt::format("{}; {}", no_pictures, no_pictures_cure));
  const std::filesystem::path library = find_library();
  // Never unloaded: VTK and Mesa leave thread-local data and exit handlers behind.
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle)
    throw Error(fmt::format("{}: cannot be loaded ({}); install the VTK and OSMesa run-time libraries",
                            library.string(), dlerror()));
  auto create = reinterpret_cast<SnapshotBackend* (*)(int)>(dlsym(handle, factory_name));
  SnapshotBackend* backend = create ? create(backend_version) : nullptr;
  if (!backend)
    throw Error(
        fmt::format("{}: has another version than this program; rebuild the target scree_snapshot_vtk",
                    library.string()));
  // Never destroyed: Mesa stops its threads at program exit, and a context must not be used after that.
  return std::shared_ptr<SnapshotBackend>(backend, [](SnapshotBackend*) {});
}

}  // namespace

bool has_pictures() { return SCREE_PICTURES; }

std::shared_ptr<SnapshotBackend> load_backend() {
  static const std::shared_ptr<SnapshotBackend> backend = load_once();
  return backend;
}

}  // namespace scree::snapshot
