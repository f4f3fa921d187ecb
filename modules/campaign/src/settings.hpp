#pragma once

#include <string>
#include <vector>

#include <scree/campaign/campaign.hpp>
#include <scree/document/table.hpp>

namespace scree::campaign {

// Settings of a table, in file order. Names of sub-tables ([set.contact]), unless inline,
// are parts of the keys.
struct Settings {
  std::vector<Setting> fixed;
  std::vector<Parameter> parameters;
};

// Settings of [set]: every list is a parameter. Throws Error at an empty list, at a repeated value in a list
// and at a repeated key.
Settings read_settings(const document::Table& table);
// Settings of a case: a list is a value.
std::vector<Setting> read_case_settings(const document::Table& table);

}  // namespace scree::campaign
