#pragma once

namespace scree::campaign {

// In the directory of a campaign: the folder with a run directory per preparation. Points branch from the last file.
inline constexpr const char* preparation_folder = "prepare";
inline constexpr const char* final_state = "final_state.h5";
// In the directory of a spectrum: the state from which it goes on.
inline constexpr const char* state_of_spectrum = "state.h5";

}  // namespace scree::campaign
