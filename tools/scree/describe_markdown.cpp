#include "describe_markdown.hpp"

#include "folded_keys.hpp"
#include "probe_columns.hpp"
#include "support/study_tables.hpp"

#include <map>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/scenario/keys.hpp>

namespace scree::tool {

namespace {

struct KindTitle {
  scree_kind kind;
  const char* title;
};
constexpr KindTitle titles[] = {{SCREE_CONTACT_LAW, "Contact laws, `[[contact]]`"},
                                {SCREE_BOUNDARY, "Boundaries, `[[boundary]]`"},
                                {SCREE_BODY_FORCE, "Body forces, `[[body_force]]`"},
                                {SCREE_PROBE, "Probes, `[[probe]]`"}};

// A bar would end the cell.
std::string cell(std::string text) {
  for (std::size_t k = 0; (k = text.find('|', k)) != std::string::npos; k += 2) text.insert(k, 1, '\\');
  return text;
}

void print_row(const std::string& key, const std::string& value, const std::string& absent,
               const std::string& doc) {
  fmt::print("| `{}` | {} | {} | {} |\n", key, cell(value), cell(absent), cell(doc));
}

void print_header(const char* title) {
  fmt::print("\n| {} | value | without it | meaning |\n|---|---|---|---|\n", title);
}

void print_column_rows(const std::vector<ColumnLine>& columns) {
  fmt::print("\n| column | unit | meaning |\n|---|---|---|\n");
  for (const ColumnLine& c : columns)
    fmt::print("| `{}` | {} | {} |\n", c.name, cell(c.unit), cell(c.meaning));
}

void print_plugin(const scree_plugin& plugin) {
  fmt::print("\n### {}\n\n{}\n", plugin.name, plugin.summary);
  if (plugin.parameter_count > 0) print_header("parameter");
  for (const ParameterLine& p : parameter_lines_of(plugin)) print_row(p.keys, p.range, p.without, p.doc);
  if (plugin.kind == SCREE_PROBE) print_column_rows(described_columns(Parameters(plugin)));
}

// What holds when a parameter is not given.
std::string without(const scree_parameter& p) {
  if (p.excludes) return fmt::format("either this or {}", p.excludes);
  if (p.flags & SCREE_REQUIRED) return "required";
  if (p.flags & SCREE_OPTIONAL) return "optional";
  if (p.type == SCREE_CHOICE) return "default " + choices_of(p)[std::size_t(p.default_value)];
  if (p.type == SCREE_BOOLEAN) return fmt::format("default {}", p.default_value != 0);
  return fmt::format("default {:g}", p.default_value);
}

}  // namespace

std::vector<ParameterLine> parameter_lines_of(const scree_plugin& plugin) {
  std::vector<ParameterLine> lines;
  std::vector<std::string> alike;  // keys of the last line
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const scree_parameter& p = plugin.parameters[k];
    const ParameterLine line = {p.key, describe_range(p), without(p), p.doc};
    const bool same = !lines.empty() && lines.back().range == line.range &&
                      lines.back().without == line.without && lines.back().doc == line.doc;
    if (!same) {
      lines.push_back(line);
      alike = {p.key};
      continue;
    }
    alike.emplace_back(p.key);
    lines.back().keys = folded(alike);
  }
  return lines;
}

namespace {

// "Tables: [scene](#scene), ..."; the second heading of a name has another address.
class Contents {
 public:
  void print(const char* title, const std::vector<std::string>& names) {
    std::vector<std::string> links;
    for (const std::string& name : names) {
      std::string address;
      for (const char c : name)
        if (c != '.') address += c;
      const int before = headings_[address]++;
      links.push_back(fmt::format("[{}](#{}{})", name, address, before ? fmt::format("-{}", before) : ""));
    }
    fmt::print("- {}: {}\n", title, fmt::join(links, ", "));
  }

 private:
  std::map<std::string, int> headings_;
};

void print_contents(PluginHost& host, const std::vector<scenario::TableDescription>& tables) {
  Contents contents;
  std::vector<std::string> names;
  for (const scenario::TableDescription& table : tables) names.push_back(table.name);
  fmt::print("\n");
  contents.print("Tables", names);
  for (const KindTitle& title : titles) contents.print(title.title, host.names(title.kind));
}

}  // namespace

void print_markdown(PluginHost& host) {
  const std::vector<scenario::TableDescription> tables = scenario::describe_tables(study_tables());
  fmt::print(
      "# Keys of a scenario\n\nPrinted by `scree describe --all`, from the declarations that scenarios are checked with. "
      "`stress_{{x,y}}` stands for `stress_x` and `stress_y`.\n");
  print_contents(host, tables);
  fmt::print("\n## Tables\n");
  for (const scenario::TableDescription& table : tables) {
    fmt::print("\n### {}\n\n`{}`: {}\n", table.name, table.header, table.doc);
    print_header("key");
    for (const scenario::KeyDescription& key : table.keys)
      print_row(key.name, key.value, key.absent, key.doc);
  }
  for (const KindTitle& title : titles) {
    fmt::print("\n## {}\n", title.title);
    if (title.kind == SCREE_PROBE)
      fmt::print(
          "\nThe first column of a series is `time` (s); `<n>` is a number that the parameters choose.\n");
    for (const std::string& name : host.names(title.kind)) print_plugin(host.find(name, title.kind));
  }
}

}  // namespace scree::tool
