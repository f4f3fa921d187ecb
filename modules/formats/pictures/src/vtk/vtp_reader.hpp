#pragma once

#include <filesystem>

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// Reads a particles .vtp file and the contacts file in the same directory, if any. Throws scree::Error.
Frame read_vtp(const std::filesystem::path& particles_file);

}  // namespace scree::pictures
