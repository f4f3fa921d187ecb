#include "error_line.hpp"
#include "instruction_level.hpp"
#include "plugins/load_check.hpp"
#include "scenes.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/plugin_host.hpp>

namespace fs = std::filesystem;
using scree::Error;
using scree::PluginHost;

namespace {

constexpr const char* linear_law = "linear_spring_dashpot";

// A temporary directory of plug-ins.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "scree_plugins_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }
  void copy(const std::string& from, const std::string& to) const {
    fs::create_directories((path_ / to).parent_path());
    fs::copy_file(fs::path(SCREE_TEST_PLUGINS) / from, path_ / to);
  }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((path_ / file).parent_path());
    std::ofstream(path_ / file) << text;
  }

 private:
  fs::path path_;
};

fs::path library_of(const scree_plugin& plugin) {
  Dl_info info = {};
  REQUIRE(dladdr(&plugin, &info) != 0);
  return info.dli_fname;
}

std::string refusal_of_plugin(PluginHost& host, const std::string& name, scree_kind kind) {
  return scree::test::error_line([&] { host.find(name, kind); }, scree::ExitStatus::bad_input);
}

}  // namespace

TEST_CASE("plug-ins are found by name and kind, and loaded once") {
  PluginHost host({SCREE_TEST_PLUGINS});
  const scree_plugin& plugin = host.find(linear_law, SCREE_CONTACT_LAW);
  CHECK(std::string(plugin.name) == linear_law);
  CHECK(plugin.kind == SCREE_CONTACT_LAW);
  CHECK(&host.find(linear_law, SCREE_CONTACT_LAW) == &plugin);
  // A box is a boundary and may be a probe as well.
  CHECK(host.find("box", SCREE_BOUNDARY).kind == SCREE_BOUNDARY);
  CHECK_THAT(host.names(SCREE_CONTACT_LAW), Catch::VectorContains(std::string(linear_law)));
  CHECK(host.locate(linear_law, SCREE_CONTACT_LAW) ==
        fs::path(SCREE_TEST_PLUGINS) / "contact" / (std::string(linear_law) + ".so"));
  CHECK(host.locate(linear_law, SCREE_BOUNDARY).empty());
}

TEST_CASE("an unknown name is refused with the nearest known one") {
  PluginHost host({SCREE_TEST_PLUGINS});
  CHECK_THAT(refusal_of_plugin(host, "linear_spring_dashpod", SCREE_CONTACT_LAW),
             Catch::Contains("no contact law plug-in 'linear_spring_dashpod'") &&
                 Catch::Contains("did you mean 'linear_spring_dashpot'?") &&
                 Catch::Contains(SCREE_TEST_PLUGINS));
  CHECK_THAT(refusal_of_plugin(host, "Gravity", SCREE_BODY_FORCE),
             Catch::Contains("did you mean 'gravity'?"));
  CHECK_THAT(refusal_of_plugin(host, "xyz", SCREE_BODY_FORCE),
             Catch::Contains("there are: ") && Catch::Contains("gravity"));
  CHECK_THAT(refusal_of_plugin(host, "gravity", SCREE_CONTACT_LAW),
             Catch::Contains("'gravity' is a body force"));
  CHECK_THAT(refusal_of_plugin(host, "", SCREE_CONTACT_LAW), Catch::Contains("no contact law plug-in ''"));
  PluginHost empty({});
  CHECK_THAT(refusal_of_plugin(empty, linear_law, SCREE_CONTACT_LAW), Catch::Contains("in any directory"));
  CHECK(empty.names(SCREE_CONTACT_LAW).empty());
}

TEST_CASE("a name cannot lead out of the directories") {
  const Folder outside;
  outside.copy("body_force/gravity.so", "trusted/body_force/gravity.so");
  outside.copy("body_force/gravity.so", "evil.so");
  outside.copy("body_force/gravity.so", "trusted/evil.so");
  PluginHost host({outside.path() / "trusted"});
  CHECK_NOTHROW(host.find("gravity", SCREE_BODY_FORCE));
  for (const std::string& name :
       {std::string("../evil"), std::string("../../evil"), (outside.path() / "evil").string(),
        std::string("./gravity"), std::string("../body_force/gravity"), std::string("gravity.so"),
        std::string("."), std::string("gravity\0x", 9)}) {
    INFO(name);
    CHECK(host.locate(name, SCREE_BODY_FORCE).empty());
    CHECK_THAT(refusal_of_plugin(host, name, SCREE_BODY_FORCE), Catch::Contains("no body force plug-in"));
  }
}

TEST_CASE("the first directory that contains a name wins") {
  const Folder first, second;
  second.copy("body_force/gravity.so", "body_force/gravity.so");
  second.copy("body_force/background_damping.so", "body_force/background_damping.so");
  first.copy("body_force/gravity.so", "body_force/gravity.so");
  PluginHost host({first.path(), second.path()});
  CHECK(library_of(host.find("gravity", SCREE_BODY_FORCE)) == first.path() / "body_force/gravity.so");
  CHECK(library_of(host.find("background_damping", SCREE_BODY_FORCE)) ==
        second.path() / "body_force/background_damping.so");
  CHECK(host.names(SCREE_BODY_FORCE) == std::vector<std::string>{"background_damping", "gravity"});
}

TEST_CASE("the best build that the processor supports is loaded, or the one that the user selects") {
  const Folder folder;
  const std::string file = std::string(linear_law) + ".so", base = "contact/" + file;
  folder.copy(base, base);
  const auto loaded = [&](const char* level) {
    const scree::test::InstructionLevel chosen(level);
    PluginHost host({folder.path()});
    return fs::relative(library_of(host.find(linear_law, SCREE_CONTACT_LAW)), folder.path()).string();
  };
  CHECK(loaded(nullptr) == base);
  CHECK(loaded("x86-64-v3") == base);  // missing: the baseline is loaded
#if defined(__x86_64__)
  const bool v3 = scree::test::is_supported(3), v4 = scree::test::is_supported(4);
  const std::string at_v3 = "contact/x86-64-v3/" + file, at_v4 = "contact/x86-64-v4/" + file;
  folder.copy(at_v3, at_v3);
  CHECK(loaded(nullptr) == (v3 ? at_v3 : base));
  folder.copy(at_v4, at_v4);
  CHECK(loaded(nullptr) == (v4 ? at_v4 : v3 ? at_v3 : base));
  CHECK(loaded("") == (v4 ? at_v4 : v3 ? at_v3 : base));
  CHECK(loaded("baseline") == base);
  if (v3) CHECK(loaded("x86-64-v3") == at_v3);
#endif
}

TEST_CASE("unusable libraries are refused with the reason and do not affect the others") {
  const Folder folder;
  folder.copy("body_force/gravity.so", "body_force/gravity.so");
  folder.copy("body_force/gravity.so", "body_force/other_name.so");
  folder.copy("body_force/gravity.so", "contact/gravity.so");
  folder.write("body_force/text.so", "no library");
  folder.write("body_force/notes.txt", "no plug-in at all");
  PluginHost host({folder.path(), SCREE_TEST_BROKEN});

  CHECK_THAT(refusal_of_plugin(host, "text", SCREE_BODY_FORCE),
             Catch::Contains("text.so: not a usable plug-in library"));
  CHECK_THAT(refusal_of_plugin(host, "other_name", SCREE_BODY_FORCE),
             Catch::Contains("contains a plug-in named 'gravity'"));
  CHECK_THAT(refusal_of_plugin(host, "gravity", SCREE_CONTACT_LAW),
             Catch::Contains("contains a body force, not a contact law") && Catch::Contains("folder body"));
  CHECK_THAT(refusal_of_plugin(host, "no_query", SCREE_BODY_FORCE),
             Catch::Contains("lacks the symbol scree_plugin_query"));
  CHECK_THAT(refusal_of_plugin(host, "no_manifest", SCREE_BODY_FORCE),
             Catch::Contains("returned no manifest"));
  CHECK_THAT(refusal_of_plugin(host, "old_version", SCREE_BODY_FORCE),
             Catch::Contains("interface version " + std::to_string(SCREE_ABI_VERSION + 1) +
                             ", this program has " + std::to_string(SCREE_ABI_VERSION)));
  CHECK_THAT(refusal_of_plugin(host, "needs_features", SCREE_BODY_FORCE),
             Catch::Contains("needs features 0x8"));
  CHECK_THAT(refusal_of_plugin(host, "other_size", SCREE_BODY_FORCE),
             Catch::Contains("interface of another version of a body force; rebuild"));
  CHECK_THAT(refusal_of_plugin(host, "fast_math", SCREE_BODY_FORCE),
             Catch::Contains("fast_math.so: was compiled with -ffast-math"));
  CHECK_THAT(refusal_of_plugin(host, "contracted", SCREE_BODY_FORCE),
             Catch::Contains("contracted.so: ") && Catch::Contains("-ffp-contract=off"));
  // Loading the former does not change the arithmetic of this program.
  volatile double smallest_normal = 0x1p-1022;
  CHECK(0.5 * smallest_normal > 0);
  // A second attempt is refused for the same reason.
  CHECK_THAT(refusal_of_plugin(host, "no_query", SCREE_BODY_FORCE), Catch::Contains("lacks the symbol"));

  std::vector<PluginHost::Broken> broken;
  const auto plugins = host.load_all(broken);
  REQUIRE(plugins.size() == 1);
  CHECK(std::string(plugins[0]->name) == "gravity");
  std::vector<std::string> names;
  for (const auto& b : broken) {
    names.push_back(b.path.stem());
    CHECK_FALSE(b.reason.empty());
  }
  CHECK_THAT(names, Catch::UnorderedEquals(std::vector<std::string>{
                        "gravity", "other_name", "text", "no_query", "no_manifest", "old_version",
                        "needs_features", "other_size", "fast_math", "contracted", "exits_on_load"}));
}

TEST_CASE("a plug-in's own refusal is passed on with its name") {
  const scree::Parameters wrong = scree::test::parameters(
      linear_law, SCREE_CONTACT_LAW,
      {{"normal_stiffness", {1}}, {"normal_damping", {0}}, {"static_friction", {0.5}}});
  const double no_box[3] = {};
  try {
    const scree::ConfiguredLaw configured(wrong, 3, no_box, no_box);
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK_THAT(error.what(),
               Catch::Equals(std::string(linear_law) + ": friction needs tangential_stiffness above 0; "
                                                       "give it, or static_friction = 0"));
  }
}

TEST_CASE("a truncated library is refused, wherever it ends") {
  const Folder folder;
  folder.copy("body_force/gravity.so", "body_force/gravity.so");
  const fs::path library = folder.path() / "body_force" / "gravity.so";
  const auto whole = fs::file_size(library);
  for (const double share : {0.001, 0.1, 0.5, 0.9, 0.999}) {
    fs::resize_file(library, std::uintmax_t(double(whole) * share));
    PluginHost host({folder.path()});
    INFO(share << " of the file");
    CHECK_THAT(refusal_of_plugin(host, "gravity", SCREE_BODY_FORCE), Catch::Contains("rebuild it"));
  }
}

TEST_CASE("a name too long for a file is reported as unknown") {
  PluginHost host({SCREE_TEST_PLUGINS});
  CHECK_THAT(refusal_of_plugin(host, std::string(5000, 'x'), SCREE_BODY_FORCE),
             Catch::Contains("no body force plug-in"));
}

TEST_CASE("an instruction level that the processor does not support is refused") {
  setenv("SCREE_LEVEL", "x86-64-v9", 1);
  PluginHost host({SCREE_TEST_PLUGINS});
  const std::string line = refusal_of_plugin(host, linear_law, SCREE_CONTACT_LAW);
  unsetenv("SCREE_LEVEL");
  CHECK_THAT(line, Catch::StartsWith("SCREE_LEVEL=x86-64-v9: ") && Catch::Contains("baseline"));
}

TEST_CASE("a library that ends the program while it is loaded is refused by name") {
  PluginHost host({SCREE_TEST_BROKEN});
  CHECK_THAT(refusal_of_plugin(host, "exits_on_load", SCREE_BODY_FORCE),
             Catch::EndsWith(
                 "exits_on_load.so: ends the program while it is loaded (status 7); remove or correct it"));
}

// Not through a host, which would end this program with success if it took the library.
TEST_CASE("a library that ends the program while it is loaded with the status of success is refused too") {
  const fs::path library = fs::path(SCREE_TEST_BROKEN) / "waiting/leaves_on_load.so";
  CHECK(scree::fatal_load(library) == "ends the program while it is loaded (status 0)");
}

TEST_CASE("a library that holds the program while it is loaded is ended after a time") {
  const fs::path library = fs::path(SCREE_TEST_BROKEN) / "waiting/waits_on_load.so";
  CHECK(scree::fatal_load(library, 0.1) == "holds the program while it is loaded (no end within 0.1 s)");
}

TEST_CASE("a pipe or a broken link in place of a library is refused, not waited for") {
  const Folder folder;
  folder.write("body_force/notes.txt", "");
  const fs::path pipe = folder.path() / "body_force/pipe.so", link = folder.path() / "body_force/link.so";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  fs::create_symlink(link, link);
  PluginHost host({folder.path()});
  CHECK_THAT(refusal_of_plugin(host, "pipe", SCREE_BODY_FORCE),
             Catch::EndsWith("pipe.so: is not a regular file; replace it by a plug-in library"));
  CHECK_THAT(refusal_of_plugin(host, "link", SCREE_BODY_FORCE),
             Catch::Contains("link.so: cannot be read (Too many levels"));
}

TEST_CASE("a law that lacks the level of the processor is named") {
  const scree::test::InstructionLevel chosen_by_host(nullptr);
  const Folder alone, both;
  const std::string so = "contact/" + std::string(linear_law) + ".so";
  alone.copy(so, so);
  both.copy(so, so);
  for (const char* level : {"x86-64-v3", "x86-64-v4"})
    both.copy("contact/" + std::string(level) + "/" + linear_law + ".so",
              "contact/" + std::string(level) + "/" + linear_law + ".so");
  PluginHost slow({alone.path()}), fast({both.path()});
  CHECK(slow.slow_laws().empty());  // not loaded yet
  slow.find(linear_law, SCREE_CONTACT_LAW);
  fast.find(linear_law, SCREE_CONTACT_LAW);
  CHECK(fast.slow_laws().empty());
  if (!scree::test::is_supported(3)) return;
  REQUIRE(slow.slow_laws().size() == 1);
  CHECK_THAT(slow.slow_laws()[0], Catch::StartsWith("contact law 'linear_spring_dashpot' (") &&
                                      Catch::Contains("; build it again with -march=x86-64-v3 as ") &&
                                      Catch::EndsWith("contact/x86-64-v3/linear_spring_dashpot.so"));
  const scree::test::InstructionLevel baseline("baseline");
  CHECK(slow.slow_laws().empty());  // chosen by the user
}

TEST_CASE("a name that no scenario may give is not offered", "[plugin_host]") {
  const Folder folder;
  folder.copy("contact/linear_spring_dashpot.so", "contact/a b.so");
  PluginHost host({folder.path()});
  const std::string line = refusal_of_plugin(host, "a b", SCREE_CONTACT_LAW);
  CHECK(line.find("no contact law plug-in 'a b' in ") == 0);
  CHECK(line.find("did you mean") == std::string::npos);
  CHECK(line.ends_with("; a name has letters, digits, '_' and '-' only"));
}
