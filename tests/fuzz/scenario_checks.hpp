#pragma once

#include "support.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <scree/run/set_up.hpp>
#include <scree/run/step_check.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::fuzz {

// Does what `scree check` does with a scene and overrides.
inline int check_scene(std::string_view text, const std::vector<std::string>& overrides) {
  static PluginHost host({SCREE_FUZZ_PLUGINS});
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("scree_fuzz_" + std::to_string(getpid()) + ".toml");
  std::ofstream(file, std::ios::binary) << text;
  return accept_or_refuse([&] {
    const scenario::Plan plan = scenario::read_plan(file, overrides, host, {spectrum::spectrum_table()});
    run::describe_step(*run::set_up(plan));
  });
}

}  // namespace scree::fuzz
