#pragma once

#include <string>
#include <vector>

#include <scree/campaign/campaign.hpp>
#include <scree/document/table.hpp>

namespace scree::campaign {

// What a table sets, in file order. Tables that are not written inline, as [set.contact], are parts of the
// keys.
struct Settings {
  std::vector<Setting> fixed;
  std::vector<Parameter> parameters;
};

// Of [set]: every list is a parameter. Throws Error at a list that is empty or holds a value twice, and at a
// key that is given twice.
Settings read_settings(const document::Table& table);
// Of a case: a list is a value.
std::vector<Setting> read_case_settings(const document::Table& table);

}  // namespace scree::campaign
