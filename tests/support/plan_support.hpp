#pragma once

#include "document_support.hpp"
#include "scene_text.hpp"
#include "scenes.hpp"
#include "temporary_folder.hpp"

#include <string>
#include <vector>

#include <scree/scenario/plan.hpp>

namespace scree::test {

// Reads a plan from a file scene.toml in a temporary folder.
inline scenario::Plan plan_of(const std::string& text, const std::vector<std::string>& overrides = {},
                              const scenario::StudyTables& studies = {}) {
  const TemporaryFolder folder;
  return scenario::read_plan(folder.write("scene.toml", text), overrides, host(), studies);
}

// Error message for a scene, without the path of the temporary folder; "no error" if there is none.
inline std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {},
                           const scenario::StudyTables& studies = {}) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.toml", text);
  std::string line = message([&] { scenario::read_plan(file, overrides, host(), studies); });
  const std::string prefix = folder.path().string() + "/";
  for (auto at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
    line.erase(at, prefix.size());
  return line;
}

}  // namespace scree::test
