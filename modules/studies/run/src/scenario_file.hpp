#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace scree::run {

inline constexpr const char* scenario_file = "scenario.toml";

// The text of scenario.toml as results that go on began with it, if it was edited or removed since, which is reported; empty if it is
// still so. began: the scenario in their state. The path of a file of bodies, which is absolute in scenario.toml only, is taken from there.
std::string restored_scenario(const std::filesystem::path& directory, const std::string& began,
                              const std::function<void(const std::string&)>& on_warning);

}  // namespace scree::run
