#pragma once

#include <filesystem>

#include <scree/pictures/frame.hpp>

namespace scree::pictures {

// Reads a frame with read_vtp() in a child process with limited time and memory, because VTK may crash on a
// damaged file. Throws scree::Error as read_vtp() does, also if the child dies.
Frame read_vtp_apart(const std::filesystem::path& particles_file);

}  // namespace scree::pictures
