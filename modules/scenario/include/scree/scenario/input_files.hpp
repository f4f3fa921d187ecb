#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <scree/document/document.hpp>
#include <scree/plugin_host.hpp>

namespace scree::scenario {

// The files on which the result of a scenario depends, besides its text.
struct InputFiles {
  std::vector<std::filesystem::path> bodies;  // the packings and the state that it begins from
  // Baseline libraries by kind and name, "contact/linear_spring_dashpot", which are the same for every
  // processor; an empty path for a plug-in that does not exist.
  std::map<std::string, std::filesystem::path> plugins;
};

// The input files of a scenario file that has been loaded. Throws Error for a state that does not exist.
InputFiles input_files(const document::Document& document, const std::filesystem::path& scenario,
                       const PluginHost& host);

// The same without the file of bodies.
std::map<std::string, std::filesystem::path> plugin_files(const document::Document& document,
                                                          const PluginHost& host);

}  // namespace scree::scenario
