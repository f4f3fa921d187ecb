#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace scree::pictures {

// Whether the program ffmpeg is on the PATH.
bool has_ffmpeg();
inline constexpr std::string_view no_ffmpeg = "the program ffmpeg is not on the PATH";

// Joins PNG pictures to a film with ffmpeg, which takes its format from the name of the file and replaces one
// that is there. Throws Error (failure) with ffmpeg's own last line if it cannot.
void write_film(const std::vector<std::filesystem::path>& pictures, int frames_per_second,
                const std::filesystem::path& film);

}  // namespace scree::pictures
