#include "program_verbs.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include <scree/files/text_file.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> project_kinds = {"contact", "boundary", "body_force", "probe"};

struct NewPluginArguments {
  std::string kind, name, directory;
};

void check_name(const std::string& name) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  const bool good = !name.empty() && name.size() <= 60 && name[0] >= 'a' && name[0] <= 'z' &&
                    std::all_of(name.begin(), name.end(), allowed);
  if (!good)
    throw Error(
        fmt::format("'{}': not a name for a plug-in; use lower-case letters, digits and _, such as "
                    "viscous_spring",
                    name));
}

// "viscous_spring" as a type: ViscousSpring.
std::string type_name(const std::string& name) {
  std::string type;
  bool capital = true;
  for (const char c : name) {
    if (c != '_') type += capital && c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
    capital = c == '_';
  }
  return type;
}

std::string replaced(std::string text, const std::string& token, const std::string& value) {
  for (std::size_t at = 0; (at = text.find(token, at)) != std::string::npos; at += value.size())
    text.replace(at, token.size(), value);
  return text;
}

void write_from(const fs::path& source, const fs::path& target, const NewPluginArguments& a) {
  std::string text = files::read_text(source);
  text = replaced(text, "plugin_kind", a.kind);
  // General checks are for laws; theirs are to cover the dashpot too.
  text = replaced(text, " plugin_values", a.kind == "contact" ? " VALUES stiffness=5000 damping=0.2" : "");
  text = replaced(text, "scree_cmake_folder",
                  (program_folder() / "../lib/cmake/scree").lexically_normal().string());
  // Last, because a name may be any of these words.
  text = replaced(text, "PluginName", type_name(a.name));
  text = replaced(text, "plugin_name", a.name);
  files::write_atomically(target, text);
}

// A library of the user hides one of the same kind and name that comes with the program.
void check_new(const NewPluginArguments& a) {
  const PluginHost host(PluginHost::default_directories());
  for (const scree_kind kind : {SCREE_CONTACT_LAW, SCREE_BOUNDARY, SCREE_BODY_FORCE, SCREE_PROBE})
    if (a.kind == kind_folder(kind) && !host.locate(a.name, kind).empty())
      throw Error(
          fmt::format("'{}': a {} of this name comes with scree; choose another", a.name, kind_name(kind)));
}

ExitStatus new_plugin(const NewPluginArguments& a) {
  check_name(a.name);
  check_new(a);
  const fs::path directory = a.directory.empty() ? fs::path(a.name) : fs::path(a.directory);
  std::error_code failed;
  if (fs::exists(directory, failed))
    throw Error(fmt::format("{}: exists already; choose another name, or --out DIR", directory.string()));
  if (!fs::create_directories(directory, failed))
    throw Error(fmt::format("{}: cannot be created ({}); choose another place with --out DIR",
                            directory.string(), failed.message()),
                ExitStatus::failure);
  const fs::path templates = data_folder(SCREE_INSTALLED_TEMPLATES, SCREE_TEMPLATES);
  write_from(templates / "CMakeLists.txt", directory / "CMakeLists.txt", a);
  write_from(templates / a.kind / "plugin.cpp", directory / (a.name + ".cpp"), a);
  write_from(templates / a.kind / "scene.toml", directory / "scene.toml", a);
  fmt::print(
      "{0}/{1}.cpp   the plug-in, to be changed\n"
      "{0}/scene.toml   a scene with it, and what must come out\n"
      "{0}/CMakeLists.txt\n\n"
      "Build and test it:\n"
      "  cmake -B {0}/build {0}\n"
      "  cmake --build {0}/build --target check\n"
      "Use it in any scene: --plugins {0}/build/plugins, or SCREE_PLUGIN_PATH={0}/build/plugins\n",
      directory.string(), a.name);
  return ExitStatus::success;
}

}  // namespace

void add_new_plugin_verb(CommandLine& line) {
  Verb verb = line.verb("new-plugin", "Write a project for a plug-in of your own, with a scene and a test");
  auto a = std::make_shared<NewPluginArguments>();
  verb.option("kind", a->kind, "contact, boundary, body_force or probe").required().one_of(project_kinds);
  verb.option("name", a->name, "Name of the plug-in: lower-case letters, digits and _").required();
  verb.option("--out", a->directory, "Directory to create (default: the name)").shown_as("DIR");
  verb.footer("Example: scree new-plugin contact viscous_spring");
  verb.action([a] { return new_plugin(*a); });
}

}  // namespace scree::tool
