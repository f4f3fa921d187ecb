#pragma once

#include <filesystem>
#include <vector>

namespace scree::pictures {

// Triangles of an STL, OBJ, PLY or VTP file, see SnapshotBackend::read_mesh.
std::vector<double> read_mesh_file(const std::filesystem::path& file);

}  // namespace scree::pictures
