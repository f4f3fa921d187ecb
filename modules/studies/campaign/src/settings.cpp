#include "settings.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <unordered_set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <scree/document/document.hpp>
#include <scree/document/message.hpp>
#include <scree/files/text.hpp>

namespace scree::campaign {

namespace {

using document::Table;
using files::one_line;

class Reader {
 public:
  explicit Reader(bool lists_vary) : lists_vary_(lists_vary) {}

  Settings take() { return std::move(settings_); }

  void read_value(const Table& table, const std::string& key, const std::string& path) {
    if (lists_vary_ && table.is_array(key))
      settings_.parameters.push_back(read_parameter(table, key, path));
    else
      settings_.fixed.push_back({path, table.toml(key), table.place(key)});
  }

  void read(const Table& table, const std::string& above) {
    for (const std::string& key : table.keys()) {
      const std::string path = above + key;
      if (table.is_table(key) && !table.is_inline_table(key)) {
        read(table.table(key), path + ".");
        continue;
      }
      if (!taken_.insert(path).second)
        throw table.error(key, fmt::format("'{}' is set twice", one_line(path)), "keep one of the two");
      read_value(table, key, path);
    }
  }

 private:
  static Parameter read_parameter(const Table& table, const std::string& key, const std::string& path) {
    Parameter parameter{path, {}};
    const std::vector<std::string> values = table.toml_elements(key);
    if (values.empty())
      throw table.error(key, fmt::format("the list of '{}' is empty", one_line(path)),
                        "give at least one value; an empty list as the value is [[]]");
    std::unordered_set<std::string_view> used;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!used.insert(values[k]).second)
        throw table.error(
            key, k, fmt::format("{} appears twice in the list of '{}'", one_line(values[k]), one_line(path)),
            "remove one; a value that is itself a list needs its own brackets, [[...]]");
      parameter.values.push_back({path, values[k], table.place(key, k)});
    }
    return parameter;
  }

  bool lists_vary_;
  Settings settings_;
  std::set<std::string> taken_;
};

// Replaces the element with the same key, or appends a new one: the order of parameters is their order in the
// names of runs.
template <class T>
void put(std::vector<T>& all, T one) {
  const auto known =
      std::find_if(all.begin(), all.end(), [&](const T& other) { return other.key == one.key; });
  if (known == all.end())
    all.push_back(std::move(one));
  else
    *known = std::move(one);
}

// One "KEY=VALUE" of the command line.
Settings read_override(const std::string& text, bool lists_vary) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(fmt::format("--set {}", one_line(text)), "is not KEY=VALUE", "write --set time.step=1e-5");
  // The path is a single key here.
  const std::string key = text.substr(0, equals), quote = key.find('\'') == std::string::npos ? "'" : "\"";
  const auto document = document::Document::parse("", "--set", {quote + key + quote + text.substr(equals)});
  Reader reader(lists_vary);
  reader.read_value(document.root(), key, key);
  return reader.take();
}

}  // namespace

Settings read_settings(const Table& table) {
  Reader reader(true);
  reader.read(table, "");
  return reader.take();
}

std::vector<Setting> read_case_settings(const Table& table) {
  Reader reader(false);
  reader.read(table, "");
  return reader.take().fixed;
}

std::string setting_text(const std::string& toml) {
  const auto json = nlohmann::json::parse(toml, nullptr, false);
  return json.is_string() ? json.get<std::string>() : toml;
}

void replace_setting(Settings& settings, const std::string& text) {
  Settings read = read_override(text, true);
  if (!read.fixed.empty()) {
    const std::string& key = read.fixed.front().key;
    std::erase_if(settings.parameters, [&](const Parameter& p) { return p.key == key; });
    put(settings.fixed, std::move(read.fixed.front()));
  } else {
    const std::string& key = read.parameters.front().key;
    std::erase_if(settings.fixed, [&](const Setting& s) { return s.key == key; });
    put(settings.parameters, std::move(read.parameters.front()));
  }
}

void replace_setting(std::vector<Setting>& settings, const std::string& text) {
  put(settings, std::move(read_override(text, false).fixed.front()));
}

}  // namespace scree::campaign
