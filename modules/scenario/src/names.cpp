#include <algorithm>

#include <fmt/format.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/scenario/names.hpp>

namespace scree::scenario {

std::size_t find_name(const document::Table& table, std::string_view key, std::string_view what,
                      const std::string& word, const std::vector<std::string>& names,
                      std::optional<std::size_t> element) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found != names.end()) return std::size_t(found - names.begin());
  const std::string problem = fmt::format("no {} '{}'", what, files::one_line(word));
  const std::string cure = document::name_cure(word, names);
  throw element ? table.error(key, *element, problem, cure) : table.error(key, problem, cure);
}

std::vector<std::string> read_stage_names(const document::Table& table,
                                          const std::vector<std::string>& names) {
  if (!table.has("stages")) return {};
  const std::vector<std::string> stages = table.strings("stages");
  if (stages.empty()) throw table.error("stages", "is empty", "name a stage, or leave it out for all stages");
  for (std::size_t k = 0; k < stages.size(); ++k) find_name(table, "stages", "stage", stages[k], names, k);
  return stages;
}

void UniqueNames::add(const document::Table& table, const std::string& name) {
  if (name.empty())
    throw table.error("name", fmt::format("the {} name is empty", what_), "give a name, such as \"first\"");
  if (!taken_.insert(name).second)
    throw table.error("name", fmt::format("the {} name '{}' is already in use", what_, files::one_line(name)),
                      "give each a different name");
}

std::string UniqueNames::add_or_number(const document::Table& table, const std::string& fallback) {
  std::string name = table.string("name", fallback);
  for (int k = 2; !table.has("name") && taken_.contains(name); ++k) name = fmt::format("{}_{}", fallback, k);
  add(table, name);
  return name;
}

void check_file_name(const document::Table& table, const std::string& name) {
  constexpr std::size_t longest = 100;
  const auto fit = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c >= 0x80; };
  if (name.empty() || name.size() > longest || !std::all_of(name.begin(), name.end(), fit))
    throw table.error("name", fmt::format("'{}' cannot be used as a file name", files::one_line(name)),
                      fmt::format("use at most {} letters, digits, '_' and '-'", longest));
}

}  // namespace scree::scenario
