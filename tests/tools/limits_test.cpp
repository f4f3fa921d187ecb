#include "program.hpp"

#include <regex>
#include <set>
#include <string>
#include <vector>

using namespace scree::test;

namespace {

// What scenarios/LIMITS.md says that one would write for each feature that is not there.
std::vector<std::string> refused_lines() {
  std::vector<std::string> found;
  for (const std::string& line : lines_of(text_of(SCREE_TEST_SOURCE "/scenarios/LIMITS.md"))) {
    if (!line.starts_with("| ") || line.starts_with("| not ")) continue;
    const std::size_t second = line.find(" | ", 2), from = line.find('`', second),
                      to = line.find('`', from + 1);
    REQUIRE(to != line.npos);
    found.push_back(line.substr(from + 1, to - from - 1));
  }
  return found;
}

// The three discs scene, in which tables have one name each, with the line in place of the table of its key.
std::string scene_with(const std::string& line) {
  const std::string base =
      "time = { step = 1e-6, duration = 1e-4 }\nmaterial = [{ name = \"glass\", density = 2500 }]\n";
  const std::vector<std::pair<std::string, std::string>> tables = {
      {"particle", "particle = [{ position = [0, 0, 0], radius = 1e-3 }]\n"},
      {"contact",
       "contact = [{ plugin = \"linear_spring_dashpot\", normal_stiffness = 1e3, normal_damping = 0 }]\n"},
      {"boundary",
       "boundary = [{ plugin = \"box\", gap = 0.01, x = \"fixed\", y = \"fixed\", z = \"fixed\" }]\n"}};
  std::string text = base;
  for (const auto& [key, table] : tables) text += line.starts_with(key + " =") ? line + "\n" : table;
  return line.starts_with("[") ? text + line + "\nname = \"x\"\n" : text;
}

}  // namespace

TEST_CASE("what the page of limits says is not there is refused in a line", "[tools]") {
  const Workspace sound(scene_with(""));
  const Outcome valid = sound.scree("check scene.toml");
  INFO(valid.err);
  REQUIRE(valid.status == 0);
  const std::vector<std::string> lines = refused_lines();
  CHECK(lines.size() > 8);
  const std::regex unknown("(?:unknown key|no [a-z ]+ plug-in) '([a-z_]+)'");
  for (const std::string& line : lines) {
    CAPTURE(line);
    const Workspace w(scene_with(line));
    const Outcome outcome = w.scree("check scene.toml");
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find('\n') == outcome.err.size() - 1);
    // It is refused for what is not there, not for what is missing beside it.
    std::smatch named;
    REQUIRE(std::regex_search(outcome.err, named, unknown));
    CHECK(line.find(named[1].str()) != line.npos);
  }
}

TEST_CASE("the plug-ins, tables and probes that the dictionary of other codes names exist", "[tools]") {
  const std::string page = text_of(SCREE_TEST_SOURCE "/scenarios/FROM_OTHER_CODES.md"),
                    keys = text_of(SCREE_TEST_SOURCE "/scenarios/KEYS.md");
  const auto all = [&](const std::string& pattern) {
    const std::regex expression(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator at(page.begin(), page.end(), expression), end; at != end; ++at)
      found.insert((*at)[1]);
    return found;
  };
  const std::set<std::string> plugins = all("plugin = \"([a-z_]+)\""),
                              tables = all("`(\\[\\[?[a-z]+\\]\\]?)");
  CHECK(plugins.size() > 5);
  CHECK(tables.size() > 10);
  for (const std::string& name : plugins) {
    CAPTURE(name);
    CHECK(keys.find("\n### " + name + "\n") != keys.npos);
  }
  for (const std::string& name : tables) {
    CAPTURE(name);
    CHECK(keys.find(name) != keys.npos);
  }
}
