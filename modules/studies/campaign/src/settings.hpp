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

// A TOML value for people: a string without its quotes, anything else as it is.
std::string setting_text(const std::string& toml);

// Replaces what the settings have for KEY by "KEY=VALUE" of the command line, read like a line of [set].
// Throws Error like read_settings, and for a text without KEY or VALUE.
void replace_setting(Settings& settings, const std::string& text);
// The same for settings in which a list is a value.
void replace_setting(std::vector<Setting>& settings, const std::string& text);

}  // namespace scree::campaign
