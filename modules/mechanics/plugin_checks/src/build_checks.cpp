#include "law_under_check.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>

// Checks of the builds of a library for several instruction levels.

namespace scree::plugin_checks {

namespace {

namespace fs = std::filesystem;
using Verdict = Check::Verdict;

constexpr const char* levels[] = {"baseline", "x86-64-v3", "x86-64-v4"};

// <dir>/contact/law.so and <dir>/contact/x86-64-v3/law.so have the same root <dir>/contact.
fs::path folder_of(const fs::path& library) {
  const fs::path folder = library.parent_path();
  return folder.filename().string().starts_with("x86-64-") ? folder.parent_path() : folder;
}

fs::path build_of(const fs::path& library, const std::string& level) {
  const fs::path folder = folder_of(library);
  return (level == "baseline" ? folder : folder / level) / library.filename();
}

// Selects an instruction level while it lives.
class LevelChoice {
 public:
  explicit LevelChoice(const char* level) {
    if (const char* before = std::getenv("SCREE_LEVEL")) before_ = before;
    ::setenv("SCREE_LEVEL", level, 1);
  }
  ~LevelChoice() {
    if (before_)
      ::setenv("SCREE_LEVEL", before_->c_str(), 1);
    else
      ::unsetenv("SCREE_LEVEL");
  }
  LevelChoice(const LevelChoice&) = delete;
  LevelChoice& operator=(const LevelChoice&) = delete;

 private:
  std::optional<std::string> before_;
};

// The same values for another build of a law.
Parameters rebuilt(const Parameters& law, const scree_plugin& plugin) {
  Parameters copy(plugin);
  const std::vector<scree_value> values = law.values();
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k)
    if (const char* key = plugin.parameters[k].key; law.given(key))
      copy.set(key, {values[k].data, values[k].data + values[k].count});
  return copy;
}

// Forces of the whole passage with one build of the law.
std::vector<double> forces_of(const Parameters& law, const fs::path& library, const CheckedPair& pair,
                              int dimension) {
  PluginHost host({folder_of(library).parent_path()});
  const Parameters parameters = rebuilt(law, host.find(law.plugin().name, SCREE_CONTACT_LAW));
  const ConfiguredLaw configured(parameters, dimension, no_bounds, no_bounds);
  const double time = contact_time_of(configured, pair, dimension);
  const LawUnderCheck checked{configured, dimension,
                              Passage(dimension, pair, time > 0 ? time : 1e-3 * pair.radius / pair.speed)};
  ContactColumns contacts(LawUnderCheck::variants);
  std::vector<double> all;
  checked.follow(contacts, {}, 0, [&](int) {
    for (std::size_t i = 0; i < contacts.size(); ++i)
      for (int k = 0; k < dimension; ++k) all.push_back(contacts.output(SCREE_FORCE, k, i));
  });
  return all;
}

// A word for the shell: no character in it has a meaning.
std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

// Vector multiplications in each loop over a batch, by disassembly; nothing without objdump.
std::optional<std::pair<int, int>> vectorised_loops(const fs::path& library, const std::string& registers) {
  const std::string command =
      fmt::format("objdump -d --no-show-raw-insn {} 2>/dev/null", shell_word(library.string()));
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) return std::nullopt;
  int loops = 0, vectorised = 0;
  bool counted = true;
  for (std::array<char, 4096> buffer; std::fgets(buffer.data(), int(buffer.size()), pipe.get());) {
    const std::string_view line = buffer.data();
    if (!line.empty() && line[0] != ' ' && line.find('<') != line.npos) {
      const bool loop = line.find("evaluate_batch") != line.npos && line.find(".cold") == line.npos;
      loops += loop;
      counted = !loop;
    } else if (!counted && line.find(registers) != line.npos &&
               (line.find("mulp") != line.npos || line.find("fmadd") != line.npos)) {
      ++vectorised;
      counted = true;
    }
  }
  if (loops == 0) return std::nullopt;
  return std::pair(vectorised, loops);
}

}  // namespace

Checks check_levels(const Parameters& law, const fs::path& library, const CheckedPair& pair, int dimension) {
  const std::string name = "the same bits at every instruction level";
  std::optional<std::vector<double>> first;
  std::string compared;
  bool same = true;
  for (const char* level : levels) {
    if (!fs::exists(build_of(library, level))) continue;
    try {
      const LevelChoice choice(level);
      const std::vector<double> forces = forces_of(law, library, pair, dimension);
      if (first) same &= forces == *first;
      if (!first) first = forces;
      compared += (compared.empty() ? "" : ", ") + std::string(level);
    } catch (const Error& error) {
      // This processor does not have the level, or the build is broken.
      if (std::string_view(error.what()).starts_with("SCREE_LEVEL")) continue;
      return {{name, Verdict::failed, error.what()}};
    }
  }
  return {{name, same ? Verdict::passed : Verdict::failed, compared}};
}

Checks check_machine_code(const fs::path& library) {
  Checks all;
  for (const auto& [level, registers] : {std::pair("x86-64-v3", "%ymm"), std::pair("x86-64-v4", "%zmm")}) {
    const std::string name = fmt::format("the loops are vectorised for {}", level);
    const fs::path build = build_of(library, level);
    if (!fs::exists(build)) {
      all.push_back({name, Verdict::skipped, "there is no build for it; add LEVELS to scree_add_plugin"});
      continue;
    }
    const auto loops = vectorised_loops(build, registers);
    if (!loops)
      all.push_back({name, Verdict::skipped, "objdump (package binutils) is not there"});
    else
      all.push_back({name, loops->first == loops->second ? Verdict::passed : Verdict::failed,
                     fmt::format("{} of {}", loops->first, counted(loops->second, "loop"))});
  }
  return all;
}

}  // namespace scree::plugin_checks
