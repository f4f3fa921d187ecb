#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace scree::report {

using Json = nlohmann::ordered_json;

// What a page is made of.
struct Results {
  std::filesystem::path directory;
  Json record;
  const char* noun;  // "run"
  const char* verb;  // of scree, by which they are repeated
};

// The sections of each kind of results, as html.
std::string run_sections(const Results& results);
std::string spectrum_sections(const Results& results);
std::string accuracy_sections(const Results& results);
std::string campaign_sections(const Results& results);
// Of modes and of quasi-static loads.
std::string study_sections(const Results& results);

}  // namespace scree::report
