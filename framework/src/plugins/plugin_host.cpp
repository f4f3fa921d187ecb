#include "machine/instruction_levels.hpp"
#include "plugins/load_check.hpp"
#include "plugins/manifest.hpp"

#include <algorithm>
#include <cfenv>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <fstream>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/error.hpp>
#include <scree/nearest.hpp>
#include <scree/plugin_host.hpp>

namespace scree {

namespace fs = std::filesystem;

namespace {

// Whether there is a file or a link; false also for names that the file system cannot represent.
bool exists_at(const fs::path& path) {
  std::error_code failed;
  return fs::exists(fs::symlink_status(path, failed));
}

// The loader maps the sizes in the headers; reading past the end of a truncated file would crash the program.
bool is_truncated(const fs::path& path) {
  std::error_code failed;
  const std::uint64_t size = fs::file_size(path, failed);
  std::ifstream file(path, std::ios::binary);
  Elf64_Ehdr header = {};
  file.read(reinterpret_cast<char*>(&header), sizeof(header));
  if (!file || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return false;  // the loader reports it
  if (header.e_shoff + std::uint64_t(header.e_shnum) * header.e_shentsize > size) return true;
  file.seekg(std::streamoff(header.e_phoff));
  for (int k = 0; k < header.e_phnum; ++k) {
    Elf64_Phdr segment = {};
    file.read(reinterpret_cast<char*>(&segment), sizeof(segment));
    if (!file || (segment.p_type == PT_LOAD &&
                  (segment.p_offset > size || segment.p_filesz > size - segment.p_offset)))
      return true;
  }
  return false;
}

// Opening a pipe would wait for a writer.
void check_file(const fs::path& path) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (!fs::exists(status))
    throw Error(fmt::format("{}: cannot be read ({}); check the link", path.string(), failed.message()));
  if (!fs::is_regular_file(status))
    throw Error(fmt::format("{}: is not a regular file; replace it by a plug-in library", path.string()));
  if (is_truncated(path))
    throw Error(fmt::format("{}: the plug-in library is truncated; rebuild it", path.string()));
}

constexpr const char* all_levels[] = {".", "x86-64-v3", "x86-64-v4"};

fs::path build_at(const char* level, const fs::path& baseline) {
  return (baseline.parent_path() / level / baseline.filename()).lexically_normal();
}

// A build of the plug-in for any instruction level, not necessarily one of this processor: the lowest.
std::optional<fs::path> any_build(const fs::path& baseline) {
  for (const char* level : all_levels)
    if (const fs::path build = build_at(level, baseline); exists_at(build)) return build;
  return std::nullopt;
}

// Where the build for the baseline is, or would be.
fs::path baseline_of(const fs::path& build) {
  const fs::path folder = build.parent_path();
  const bool is_level =
      std::find(std::begin(all_levels), std::end(all_levels), folder.filename()) != std::end(all_levels);
  return is_level ? folder.parent_path() / build.filename() : build;
}

fs::path best_build(const fs::path& baseline) {
  for (const std::string& level : instruction_levels())
    if (const fs::path build = build_at(level.c_str(), baseline); exists_at(build)) return build;
  throw Error(fmt::format(
      "{}: is built only for instruction levels that this processor or SCREE_LEVEL excludes; build "
      "all levels: cmake -DSCREE_LEVELS=all in the build directory, then build again, or tools/test",
      baseline.string()));
}

constexpr scree_kind all_kinds[] = {SCREE_CONTACT_LAW, SCREE_BOUNDARY, SCREE_BODY_FORCE, SCREE_PROBE};

// dlerror() repeats the path, with more detail than a user needs; the part behind the first ": " is the
// reason.
std::string loader_reason() {
  const char* text = dlerror();
  const std::string all = text ? text : "unknown reason";
  const auto colon = all.find(": ");
  return colon == std::string::npos ? all : all.substr(colon + 2);
}

}  // namespace

struct PluginHost::Library {
  fs::path path;
  void* handle = nullptr;
  const scree_plugin* plugin = nullptr;

  Library(const fs::path& p, bool trusted) : path(p) {
    check_file(path);
    if (const auto fault = trusted ? std::nullopt : fatal_load(path))
      throw Error(fmt::format("{}: {}; remove or correct it", path.string(), *fault));
    // A library built with -ffast-math changes the treatment of denormal numbers when it is loaded.
    std::fenv_t numerics;
    std::fegetenv(&numerics);
    handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    std::fesetenv(&numerics);
    if (!handle)
      throw Error(
          fmt::format("{}: not a usable plug-in library ({}); rebuild it", path.string(), loader_reason()));
    const auto query = reinterpret_cast<scree_query_function>(dlsym(handle, SCREE_QUERY_SYMBOL));
    if (!query)
      fail(fmt::format("lacks the symbol {}; export the plug-in with one of the SCREE_*_PLUGIN macros",
                       SCREE_QUERY_SYMBOL));
    try {
      plugin = query();
    } catch (...) {
      fail(fmt::format("{} threw an exception; let it return a manifest", SCREE_QUERY_SYMBOL));
    }
    if (const auto problem = manifest_problem(plugin)) fail(*problem);
    if (path.stem() != plugin->name)
      fail(fmt::format("contains a plug-in named '{}'; name the library {}.so", plugin->name, plugin->name));
  }
  ~Library() {
    if (handle) dlclose(handle);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

 private:
  [[noreturn]] void fail(const std::string& reason) {
    dlclose(handle);
    throw Error(fmt::format("{}: {}", path.string(), reason));
  }
};

const char* kind_folder(scree_kind kind) {
  switch (kind) {
    case SCREE_CONTACT_LAW:
      return "contact";
    case SCREE_BOUNDARY:
      return "boundary";
    case SCREE_BODY_FORCE:
      return "body_force";
    case SCREE_PROBE:
      return "probe";
  }
  return "";
}

const char* kind_name(scree_kind kind) {
  switch (kind) {
    case SCREE_CONTACT_LAW:
      return "contact law";
    case SCREE_BOUNDARY:
      return "boundary";
    case SCREE_BODY_FORCE:
      return "body force";
    case SCREE_PROBE:
      return "probe";
  }
  return "unknown";
}

PluginHost::PluginHost(std::vector<fs::path> directories) : directories_(std::move(directories)) {}
PluginHost::~PluginHost() = default;

std::vector<fs::path> PluginHost::default_directories() {
  std::error_code failed;
  const fs::path bin = fs::read_symlink("/proc/self/exe", failed).parent_path();
  std::vector<fs::path> found;
  for (const char* relative : {"../plugins", "../" SCREE_INSTALL_LIBDIR "/scree/plugins"})
    if (fs::is_directory(bin / relative, failed)) found.push_back((bin / relative).lexically_normal());
  return found;
}

namespace {

// Names come from scenario files and must not lead out of the directories.
bool is_plain(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
  });
}

}  // namespace

std::vector<std::string> PluginHost::names(scree_kind kind) const {
  std::set<std::string> found;
  for (const fs::path& directory : directories_) {
    std::error_code failed;
    for (const char* level : all_levels)
      for (const auto& entry : fs::directory_iterator(directory / kind_folder(kind) / level, failed))
        if (entry.path().extension() == ".so") found.insert(entry.path().stem());
  }
  return {found.begin(), found.end()};
}

namespace {

// Whether a library comes with the program; others are tried in a child process first.
bool is_own(const fs::path& library) {
  const std::vector<fs::path> own = PluginHost::default_directories();
  return std::find(own.begin(), own.end(), library.parent_path().parent_path()) != own.end();
}

}  // namespace

const scree_plugin* PluginHost::load(const fs::path& path) {
  const fs::path baseline = baseline_of(path);
  std::unique_ptr<Library>& library = libraries_[baseline];
  if (!library) library = std::make_unique<Library>(best_build(baseline), is_own(baseline));
  return library->plugin;
}

fs::path PluginHost::locate(const std::string& name, scree_kind kind) const {
  if (!is_plain(name)) return {};
  for (const fs::path& directory : directories_)
    if (const auto build = any_build(directory / kind_folder(kind) / (name + ".so"))) return *build;
  return {};
}

void PluginHost::refuse(const std::string& name, scree_kind kind) const {
  std::vector<std::string> known = names(kind);
  std::erase_if(known, [](const std::string& other) { return !is_plain(other); });
  std::string cure = known.empty() ? "" : fmt::format("; there are: {}", fmt::join(known, ", "));
  if (const auto near = nearest_word(name, known)) cure = fmt::format("; did you mean '{}'?", *near);
  for (const scree_kind other : all_kinds)
    if (other != kind && !locate(name, other).empty())
      cure = fmt::format("; '{}' is a {}{}", name, kind_name(other), cure);
  if (!is_plain(name)) cure = "; a name has letters, digits, '_' and '-' only" + cure;
  std::vector<std::string> places;
  for (const fs::path& directory : directories_) places.push_back((directory / kind_folder(kind)).string());
  throw Error(fmt::format("no {} plug-in '{}' in {}{}", kind_name(kind), name,
                          places.empty() ? "any directory" : fmt::format("{}", fmt::join(places, ", ")),
                          cure));
}

const scree_plugin& PluginHost::find(const std::string& name, scree_kind kind) {
  const fs::path path = locate(name, kind);
  if (path.empty()) refuse(name, kind);
  const scree_plugin& plugin = *load(path);
  if (plugin.kind != std::uint32_t(kind))
    throw Error(fmt::format("{}: contains a {}, not a {}; move it to the folder {}", path.string(),
                            kind_name(scree_kind(plugin.kind)), kind_name(kind),
                            kind_folder(scree_kind(plugin.kind))));
  return plugin;
}

std::vector<std::string> PluginHost::slow_laws() const {
  const std::vector<std::string> levels = instruction_levels();
  std::vector<std::string> lines;
  if (std::getenv("SCREE_LEVEL") || levels.front() == ".") return lines;
  const std::string& level = levels[levels.size() - 2];  // the lowest above the baseline
  for (const auto& [baseline, library] : libraries_)
    if (library && library->plugin->kind == SCREE_CONTACT_LAW && library->path == baseline)
      lines.push_back(fmt::format(
          "contact law '{}' ({}) is built for the baseline of x86-64 only, on which laws are several times "
          "slower than this processor allows; build it again with -march={} as {}",
          library->plugin->name, baseline.string(), level,
          (baseline.parent_path() / level / baseline.filename()).string()));
  return lines;
}

std::vector<const scree_plugin*> PluginHost::load_all(std::vector<Broken>& broken) {
  std::vector<const scree_plugin*> plugins;
  for (const scree_kind kind : all_kinds)
    for (const std::string& name : names(kind)) {
      try {
        plugins.push_back(&find(name, kind));
      } catch (const Error& error) {
        broken.push_back({locate(name, kind), error.what()});
      }
    }
  return plugins;
}

}  // namespace scree
