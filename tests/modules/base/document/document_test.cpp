#include "document_support.hpp"
#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

using namespace scree;
using namespace scree::document;
using namespace scree::test;
namespace fs = std::filesystem;

TEST_CASE("a file that cannot be a scene is refused with the reason and a cure") {
  const TemporaryFolder folder;
  const std::string good = folder.write("david_sweep.toml", "a = 1\n").string();
  CHECK(Document::load(good).root().place("a") == good + ":1:5");

  const auto load = [](const fs::path& path) { return message([&] { Document::load(path); }); };
  for (const char* name : {"david_swep.toml", "david_sweep", "David_Sweep.tml"}) {
    const std::string path = (folder / name).string();
    CHECK(load(path) == path + ": cannot be read (No such file or directory); did you mean '" + good + "'?");
  }
  CHECK(
      load(folder / "other.toml").ends_with(": cannot be read (No such file or directory); check the path"));
  CHECK(load(folder.path()) ==
        folder.path().string() + ": cannot be read (Is a directory); give a file in it, such as " + good);
  CHECK(load(good + "/x.toml").ends_with(": cannot be read (Not a directory); check the path"));
  CHECK(load("").starts_with("'': cannot be read ("));

  using namespace std::string_literals;
  CHECK(load(folder.write("binary.toml", "a = 1\n\0\x01"s))
            .ends_with("(a binary file); give a scene as TOML text"));
  CHECK(load(folder.write("wide.toml", "\xFF\xFE"s + "a\0"s)).ends_with("(UTF-16 text); save it as UTF-8"));
  for (const char* nothing : {"", "\n\n# only a comment\n", "\xEF\xBB\xBF"}) {
    const std::string path = folder.write("empty.toml", nothing).string();
    CHECK(load(path) ==
          path + ":1:1: the file holds no key; write a scene: [scene], [time], [particles], ...");
  }
}

TEST_CASE("a huge file is refused at once") {
  const TemporaryFolder folder;
  const fs::path huge = folder.write("huge.toml", "a = 1\n");
  fs::resize_file(huge, 100u << 20);
  CHECK(message([&] { Document::load(huge); }) ==
        huge.string() +
            ": cannot be read (larger than 16 MiB); give a scene; many particles belong in a packing file");
}

TEST_CASE("the first override that is undone by a later one is told") {
  const auto conflict = [](const std::vector<std::string>& overrides) {
    return Document::parse("[time]\nstep = 1\n", "scene.toml", overrides).conflict();
  };
  CHECK(conflict({"time.step=2", "time.duration=3"}).empty());
  CHECK(conflict({"time.step=2", "time.step=3"}) == "--set time.step=2 is undone by --set time.step=3");
  CHECK(conflict({"time.step=2", "time={step=4}"}) == "--set time.step=2 is undone by --set time={step=4}");
}
