#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <scree/child_process.hpp>
#include <scree/error.hpp>

namespace scree::pictures {

// Reads a file with VTK in a child process of limited time and memory, since a damaged file may end or
// hold VTK. Returns what `read` sends. Throws what it throws as Error, or `damaged`.
std::string read_apart(const std::filesystem::path& file, const Error& damaged,
                       const std::function<void(const Send&)>& read);

}  // namespace scree::pictures
