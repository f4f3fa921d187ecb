#pragma once

#include <memory>

#include <scree/snapshot/backend.hpp>

namespace scree::snapshot {

// Loads libscree_snapshot_vtk.so, and VTK with it, from the build or install tree of the running program;
// once, and for as long as the program runs. Throws scree::Error where it is missing, broken or of another
// version.
std::shared_ptr<SnapshotBackend> load_backend();

}  // namespace scree::snapshot
