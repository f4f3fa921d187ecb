#pragma once

#include "results.hpp"

// Sections that pages of several kinds have.
namespace scree::report {

// The title of the results: that of the record, or of the scene, or the name of the directory.
std::string title_of(const Results& results);
// A sentence beside a coloured bar; kind: good, bad or open.
std::string mark(const char* kind, const std::string& text);
// How the results ended, and how many expectations are met, in sentences.
std::string verdict(const Results& results);
std::string expectations(const Results& results);
std::string warnings(const Results& results);
// The result of scree cycles, if it has left one beside the record; of several runs, a row for each.
std::string cycles_section(const Results& results);
std::string verdicts_of_cycles(const Results& results);
// The command, the program and the inputs by which the results are repeated to the bit, and the scenario.
std::string repetition(const Results& results);
// The version and the commit of the program.
std::string program_of(const Results& results);
// The scenario as resolved, folded.
std::string scenario_text(const Results& results);

}  // namespace scree::report
