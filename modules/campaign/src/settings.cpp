#include "settings.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

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

  void read(const Table& table, const std::string& above) {
    for (const std::string& key : table.keys()) {
      const std::string path = above + key;
      if (table.is_table(key) && !table.is_inline_table(key)) {
        read(table.table(key), path + ".");
        continue;
      }
      if (!taken_.insert(path).second)
        throw table.error(key, fmt::format("'{}' is set twice", one_line(path)), "keep one of the two");
      if (lists_vary_ && table.is_array(key))
        settings_.parameters.push_back(read_parameter(table, key, path));
      else
        settings_.fixed.push_back({path, table.toml(key), table.place(key)});
    }
  }

 private:
  static Parameter read_parameter(const Table& table, const std::string& key, const std::string& path) {
    Parameter parameter{path, {}};
    const std::vector<std::string> values = table.toml_elements(key);
    if (values.empty())
      throw table.error(key, fmt::format("the list of '{}' is empty", one_line(path)),
                        "give at least one value");
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (std::find(values.begin(), values.begin() + std::ptrdiff_t(k), values[k]) <
          values.begin() + std::ptrdiff_t(k))
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

}  // namespace scree::campaign
