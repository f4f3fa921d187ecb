#pragma once

#include <filesystem>

#include <scree/snapshot/frame.hpp>

namespace scree::snapshot {

// Frame of a particles .vtp file and of the contacts file beside it, if any. Throws scree::Error.
Frame read_vtp(const std::filesystem::path& particles_file);

}  // namespace scree::snapshot
