#include "plugins/instruction_levels.hpp"

#include <algorithm>
#include <cfenv>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <fstream>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/error.hpp>
#include <scree/nearest.hpp>
#include <scree/plugin_host.hpp>

namespace scree {

namespace fs = std::filesystem;

namespace {

// Whether a file exists; false also for names that the file system cannot represent.
bool exists_at(const fs::path& path) {
  std::error_code failed;
  return fs::exists(path, failed);
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
    if (!file || (segment.p_type == PT_LOAD && segment.p_offset + segment.p_filesz > size)) return true;
  }
  return false;
}

fs::path best_build(const fs::path& baseline) {
  for (const std::string& level : instruction_levels())
    if (const fs::path build = baseline.parent_path() / level / baseline.filename(); exists_at(build))
      return build.lexically_normal();
  return baseline;
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

std::size_t interface_size(std::uint32_t kind) {
  switch (kind) {
    case SCREE_CONTACT_LAW:
      return sizeof(scree_contact_law);
    case SCREE_BOUNDARY:
      return sizeof(scree_boundary);
    case SCREE_BODY_FORCE:
      return sizeof(scree_body_force);
    case SCREE_PROBE:
      return sizeof(scree_probe);
  }
  return 0;
}

// Why a library of the right version cannot be used all the same, and the cure; empty if it can.
std::string fault_of_build(const scree_plugin& plugin) {
  if (plugin.struct_size != sizeof(scree_plugin) || plugin.parameter_size != sizeof(scree_parameter))
    return "was built with other headers of the same interface version; rebuild it against this version";
  if (plugin.numerics & SCREE_FAST_MATH)
    return "was compiled with -ffast-math or a part of it, which changes results; compile it without";
  if (plugin.numerics & SCREE_CONTRACTED)
    return "was compiled so that products and sums are fused, which changes results; add -ffp-contract=off";
  if (interface_size(plugin.kind) == 0)
    return fmt::format("contains a plug-in of an unknown kind {}; rebuild it against this version",
                       plugin.kind);
  // Each interface begins with its struct_size.
  if (!plugin.interface ||
      *static_cast<const std::uint32_t*>(plugin.interface) != interface_size(plugin.kind))
    return fmt::format("has the interface of another version of a {}; rebuild it against this version",
                       kind_name(scree_kind(plugin.kind)));
  return "";
}

}  // namespace

struct PluginHost::Library {
  fs::path path;
  void* handle = nullptr;
  const scree_plugin* plugin = nullptr;

  explicit Library(const fs::path& p) : path(p) {
    if (is_truncated(path))
      throw Error(fmt::format("{}: the plug-in library is truncated; rebuild it", path.string()));
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
    plugin = query();
    if (!plugin || plugin->struct_size < offsetof(scree_plugin, kind))
      fail(fmt::format("{} returned no manifest; rebuild it against this version", SCREE_QUERY_SYMBOL));
    if (plugin->abi_version != SCREE_ABI_VERSION)
      fail(fmt::format("plug-in interface version {}, this program has {}; rebuild it against this version",
                       plugin->abi_version, SCREE_ABI_VERSION));
    if (plugin->features != 0)
      fail(fmt::format("needs features {:#x} that this program lacks; use a newer scree", plugin->features));
    if (const std::string fault = fault_of_build(*plugin); !fault.empty()) fail(fault);
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

std::vector<std::string> PluginHost::names(scree_kind kind) const {
  std::set<std::string> found;
  for (const fs::path& directory : directories_) {
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(directory / kind_folder(kind), failed))
      if (entry.path().extension() == ".so") found.insert(entry.path().stem());
  }
  return {found.begin(), found.end()};
}

const scree_plugin* PluginHost::load(const fs::path& path) {
  std::unique_ptr<Library>& library = libraries_[path];
  if (!library) library = std::make_unique<Library>(best_build(path));
  return library->plugin;
}

fs::path PluginHost::locate(const std::string& name, scree_kind kind) const {
  // Names come from scenario files and must not lead out of the directories.
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
  };
  if (!std::all_of(name.begin(), name.end(), plain)) return {};
  for (const fs::path& directory : directories_)
    if (const fs::path path = directory / kind_folder(kind) / (name + ".so"); exists_at(path)) return path;
  return {};
}

void PluginHost::refuse(const std::string& name, scree_kind kind) const {
  const std::vector<std::string> known = names(kind);
  std::string cure = known.empty() ? "" : fmt::format("; there are: {}", fmt::join(known, ", "));
  if (const auto near = nearest_word(name, known)) cure = fmt::format("; did you mean '{}'?", *near);
  for (const scree_kind other : all_kinds)
    if (other != kind && !locate(name, other).empty())
      cure = fmt::format("; '{}' is a {}{}", name, kind_name(other), cure);
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
  const std::string level = levels[levels.size() - 2];  // the lowest above the baseline
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
