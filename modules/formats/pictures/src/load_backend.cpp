#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/companion_library.hpp>
#include <scree/pictures/load_backend.hpp>

namespace scree::pictures {
namespace {

constexpr files::CompanionLibrary library = {
    .target = "scree_pictures_vtk",
    .factory = "scree_create_snapshot_backend",
    .purpose = "snapshots and images",
    .without = "leave them out",
    .needs = "the VTK and OSMesa run-time libraries",
};

std::shared_ptr<SnapshotBackend> load_once() {
  // A library from an earlier build with pictures may still be there.
  if (!has_pictures()) throw Error(fmt::format("{}; {}", no_pictures, no_pictures_cure));
  // Never destroyed: Mesa stops its threads at program exit, and a context must not be used after that.
  return {files::load_companion<SnapshotBackend>(library, backend_version), [](SnapshotBackend*) {}};
}

}  // namespace

bool has_pictures() { return SCREE_PICTURES; }

std::shared_ptr<SnapshotBackend> load_backend() {
  static const std::shared_ptr<SnapshotBackend> backend = load_once();
  return backend;
}

}  // namespace scree::pictures
