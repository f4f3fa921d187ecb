#pragma once

#include <memory>
#include <string_view>

#include <scree/pictures/backend.hpp>

namespace scree::pictures {

// False if the program was built with the CMake option SCREE_PICTURES=OFF; load_backend then throws.
bool has_pictures();

inline constexpr std::string_view no_pictures = "this scree was built without pictures (SCREE_PICTURES=OFF)";
inline constexpr std::string_view no_pictures_cure = "build it with VTK (preset release)";

// Loads libscree_pictures_vtk.so, and with it VTK, from the build or install tree of the running program. The
// library is loaded once and never unloaded. Throws scree::Error if it is missing, broken or outdated.
std::shared_ptr<SnapshotBackend> load_backend();

}  // namespace scree::pictures
