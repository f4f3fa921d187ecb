#pragma once

#include <filesystem>
#include <vector>

namespace scree::tool {

// Throws Error unless the program ffmpeg is on the PATH.
void require_ffmpeg(const std::filesystem::path& movie);

// Joins PNG pictures of one size to a movie, whose format ffmpeg takes from the name of the file. Throws
// Error (failure) with ffmpeg's own last line if it cannot.
void write_movie(const std::vector<std::filesystem::path>& pictures, int frames_per_second,
                 const std::filesystem::path& movie);

}  // namespace scree::tool
