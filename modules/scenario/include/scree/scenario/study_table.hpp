#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <scree/scenario/keys.hpp>

namespace scree::scenario {

struct Plan;

// A table of a scenario, such as [spectrum], that a study reads in its own module.
struct StudyTable {
  const char* name;  // of the table and of the verb; a scenario that has the table needs no stages
  // The table and the tables below it, for scree describe.
  std::vector<TableDescription> (*describe)();
  // Reads and checks the table in a plan that is complete otherwise. Returns what scree check prints of it in one line;
  // empty if the scenario does not have the table. Throws Error at the wrong key.
  std::string (*check)(const Plan& plan);
  // Whether a quantity of [[expect]] is a result of the study; check() then checks Plan::study_expectations.
  bool (*judges)(std::string_view quantity);
};

using StudyTables = std::vector<StudyTable>;

// All tables of a scenario, tables of studies last. Parameters of plug-ins stand beside the keys of their tables.
std::vector<TableDescription> describe_tables(const StudyTables& studies = {});

}  // namespace scree::scenario
