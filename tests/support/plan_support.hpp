#pragma once

#include "document_support.hpp"
#include "scene_text.hpp"
#include "scenes.hpp"
#include "temporary_folder.hpp"

#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::test {

// A plan read from a file scene.toml in a folder of its own.
inline scenario::Plan plan_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const TemporaryFolder folder;
  return scenario::read_plan(folder.write("scene.toml", text), overrides, host());
}

// What is said of a scene, without the folder that the test made; "no error" if nothing.
inline std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.toml", text);
  std::string line = message([&] { scenario::read_plan(file, overrides, host()); });
  const std::string prefix = folder.path().string() + "/";
  for (auto at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
    line.erase(at, prefix.size());
  return line;
}

}  // namespace scree::test
