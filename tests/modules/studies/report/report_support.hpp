#pragma once

#include "temporary_folder.hpp"

#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/report/page.hpp>

namespace scree::test {

// Writes a file, and its folder if that is missing.
inline void write(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  std::filesystem::create_directories((folder / name).parent_path());
  folder.write(name, text);
}

// A run of two stages with series, as its files say.
inline void write_run(const TemporaryFolder& folder) {
  folder.write(
      "run.json",
      R"({"version": "1.2.3", "commit": "0123abcd4567", "status": "finished", "title": "Beads & <walls>", "seed": 7,
    "threads": 2, "step": 1e-5, "wall_s": 150, "stepping_s": 140, "output_s": 10, "particle_steps_per_second": 2.5e6,
    "steps": 12345, "time": 0.12345, "energy_residual": 1.5e-7, "momentum_residual": 2e-16,
    "max_overlap_ratio": 0.02, "min_steps_per_contact": 40.5, "state_hash": "0123456789abcdef",
    "footprint": {"bodies": 20000, "degrees_of_freedom": 60000, "bytes_per_body": 250, "bytes_per_pair": 90},
    "stages": [{"name": "fall", "start": 0, "end": 0.1, "steps": 10000, "ended": "duration"},
               {"name": "press", "start": 0.1, "end": 0.12345, "steps": 2345, "ended": "condition"}],
    "expect": [{"requirement": "it rests", "quantity": "kinetic_energy", "value": 2e-9, "met": true, "at_most": 1e-8},
               {"requirement": "it is stiff", "quantity": "box.k.last", "value": 3, "met": false, "reference": 2,
                "tolerance": 0.1}],
    "warnings": ["the step is long; use <b>a shorter one"],
    "inputs": {"bodies": "00aa", "plugins": {"contact/linear": "00bb"}},
    "scenario": "[scene]\ntitle = \"Beads\"\n[[contact]]\nplugin = \"linear\"\n[[chart]]\nname = \"k\"\ntitle = \"k over t\"\nprobe = \"box\"\ny = \"k\"\n"})");
  write(folder, "series/box.csv", "time [s],k [N/m]\n0,1000\n0.1,2000\n0.2,3000\n");
}

// The tags of a page that are not closed as they should be; empty for a page that is well formed.
inline std::string misplaced_tag(const std::string& html) {
  static const std::set<std::string> alone = {"meta", "img", "br", "wbr", "!DOCTYPE"};
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != html.npos; at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    if (end == html.npos) return "an end";
    const bool closes = html[at + 1] == '/';
    const std::size_t begin = at + (closes ? 2 : 1);
    const std::string name = html.substr(begin, html.find_first_of(" />\n", begin) - begin);
    if (closes && (open.empty() || open.back() != name)) return "/" + name;
    if (closes) open.pop_back();
    if (!closes && html[end - 1] != '/' && !alone.contains(name)) open.push_back(name);
  }
  return open.empty() ? "" : open.back();
}

// The page of a folder, checked for what every page must be.
inline std::string checked_page(const TemporaryFolder& folder) {
  const std::string page = report::page_of(folder.path());
  CHECK(misplaced_tag(page).empty());
  CHECK(report::is_page(page));
  CHECK(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
  // It loads nothing, and runs nothing.
  for (const char* what : {"<script", "http://www.w3.org/TR", "src=\"http", "@import", "onload"})
    CHECK(page.find(what) == page.npos);
  return page;
}

}  // namespace scree::test
