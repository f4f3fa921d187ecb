#include "document_support.hpp"
#include "temporary_folder.hpp"

#include <cerrno>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <scree/run/run_directory.hpp>
#include <scree/run/session.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

// The line of the Error (failure) that the action throws.
template <class Action>
static std::string failure(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::failure);
    return error.what();
  }
  return "no error";
}

// In place of that of the system: of a file system without locks while this is set.
static bool no_locks = false;

extern "C" int flock(int descriptor, int operation) {
  if (!no_locks) return int(syscall(SYS_flock, descriptor, operation));
  errno = ENOLCK;
  return -1;
}

namespace {

using Existing = RunDirectory::Existing;

std::string reason(const fs::path& path, Existing existing) {
  return message([&] { RunDirectory(path, existing); });
}

}  // namespace

TEST_CASE("the folder of a run has a name even if its scenario has none", "[run]") {
  CHECK(RunDirectory::default_for("..toml") == fs::path("runs/scenario"));
  CHECK(RunDirectory::default_for("...toml", RunDirectory::Kind::campaign) == fs::path("campaigns/scenario"));
  CHECK(RunDirectory::default_for("a/b.toml", RunDirectory::Kind::campaign) == fs::path("campaigns/b"));
}

TEST_CASE("discarding a directory keeps what existed before", "[run]") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "there");
  RunDirectory below(folder / "there/a/b", Existing::refuse), there(folder / "there", Existing::refuse);
  below.create();
  below.write_file("run.json", "{}");
  CHECK(fs::exists(folder / "there/a/b/run.json"));
  below.discard();
  CHECK(fs::is_empty(folder / "there"));
  there.create();
  there.discard();
  CHECK(fs::exists(folder / "there"));
}

TEST_CASE("a directory that a run has taken is refused to others, and is gone if nothing was written",
          "[run]") {
  const TemporaryFolder folder;
  {
    RunDirectory first(folder / "a/run", Existing::refuse);
    first.take();
    for (const Existing existing : {Existing::refuse, Existing::replace, Existing::keep}) {
      RunDirectory second(folder / "a/run", existing);
      CHECK(message([&] {
              second.take();
            }).ends_with("a/run: another run is running there; wait for it, or give another --out"));
    }
  }
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("what another run wrote before the directory was taken is not overwritten", "[run]") {
  const TemporaryFolder folder;
  RunDirectory late(folder / "run", Existing::refuse);
  {
    RunDirectory first(folder / "run", Existing::refuse);
    first.create();
    first.write_file("run.json", "{}");
  }
  CHECK(message([&] {
          late.take();
        }).ends_with("already contains a run; give another --out, or --overwrite to replace it"));
}

TEST_CASE("numbered directories go to one run each", "[run]") {
  const TemporaryFolder folder;
  const RunDirectory first = RunDirectory::numbered(folder / "run"),
                     second = RunDirectory::numbered(folder / "run"),
                     third = RunDirectory::numbered(folder / "run");
  CHECK(first.path() == folder / "run");
  CHECK(second.path() == folder / "run-2");
  CHECK(third.path() == folder / "run-3");
}

TEST_CASE("a run that is replaced leaves what it did not write", "[run]") {
  const TemporaryFolder folder;
  const fs::path run = folder / "run";
  {
    RunDirectory first(run, Existing::refuse);
    first.create();
    first.write_file("run.json", "{}");
    for (const char* name : {"charts/work.png", "images/frame.png"}) {
      first.add(name);
      fs::create_directory((run / name).parent_path());
      folder.write("run/" + std::string(name), "drawn");
    }
    folder.write("run/images/frame.png.part", "killed");
    for (const char* name : {"run/charts/my.png", "run/letter.txt", "run/log.txt"})
      folder.write(name, "mine");
  }
  RunDirectory second(run, Existing::replace);
  second.create();
  for (const char* name : {"charts/my.png", "letter.txt", "log.txt"}) CHECK(text_of(run / name) == "mine");
  for (const char* name : {"run.json", "charts/work.png", "images", "written.txt"})
    CHECK_FALSE(fs::exists(run / name));
  CHECK_THROWS_WITH(second.add("charts/my.png"), Catch::Contains("was not written by a run"));
}

TEST_CASE("a run is not replaced if its list or its folders lead elsewhere", "[run]") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "run");
  folder.write("run/run.json", "{}");
  folder.write("precious", "mine");
  const std::vector<std::string> outside = {"../precious", folder / "precious", "series/../../precious", ""};
  for (const std::string& line : outside) {
    folder.write("run/written.txt", "run.json\n" + line + "\n");
    CHECK(reason(folder / "run", Existing::replace).find("run/written.txt:2: ") != std::string::npos);
  }
  fs::create_directory_symlink(folder.path(), folder / "run/elsewhere");
  folder.write("run/written.txt", "run.json\nelsewhere/precious\n");
  CHECK(reason(folder / "run", Existing::replace).find("leads out of the directory") != std::string::npos);
  folder.write("run/written.txt", "run.json\n");
  fs::rename(folder / "run/elsewhere", folder / "run/series");
  CHECK(reason(folder / "run", Existing::replace).find("run/series: is a symbolic link") !=
        std::string::npos);
  CHECK(text_of(folder / "precious") == "mine");
  CHECK(text_of(folder / "run/run.json") == "{}");
}

TEST_CASE("a file that cannot be removed is an error, and stays listed", "[run]") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "run/scenario.toml/below");
  folder.write("run/run.json", "{}");
  folder.write("run/written.txt", "run.json\nscenario.toml\n");
  RunDirectory directory(folder / "run", Existing::replace);
  CHECK_THROWS_WITH(directory.create(),
                    Catch::Contains("run/scenario.toml: cannot be removed (Is a directory)"));
  CHECK(text_of(folder / "run/written.txt") == "run.json\nscenario.toml\n");
  CHECK(text_of(folder / "run/run.json") == "{}");
}

TEST_CASE("a file that is called as the list is not taken for one", "[run]") {
  const TemporaryFolder folder;
  folder.write("written.txt", "letters to write\n");
  for (const Existing existing : {Existing::refuse, Existing::replace, Existing::keep})
    CHECK(reason(folder.path(), existing)
              .ends_with("contains files that are not part of a scree run; give another --out"));
}

TEST_CASE("a run that is kept goes on behind what it had listed", "[run]") {
  const TemporaryFolder folder;
  std::uint64_t size = 0;
  {
    RunDirectory first(folder / "run", Existing::refuse);
    first.create();
    first.write_file("run.json", "{}");
    size = first.written().size();
    first.write_file("final_packing.csv", "");
  }
  RunDirectory again(folder / "run", Existing::keep);
  again.create();
  CHECK(again.written().size() > size);
  again.written().return_to(size);
  CHECK(fs::exists(folder / "run/run.json"));
  CHECK_FALSE(fs::exists(folder / "run/final_packing.csv"));
}

TEST_CASE("a directory that is moved or removed is noticed when the next file is written", "[run]") {
  const TemporaryFolder folder;
  RunDirectory directory(folder / "run", Existing::refuse);
  directory.create();
  directory.write_file("run.json", "{\"status\": \"running\"}");
  const auto problems = [&] {
    return std::vector{failure([&] { directory.add("a.csv"); }), failure([&] { directory.add("run.json"); }),
                       failure([&] { directory.write_file("b.csv", ""); })};
  };
  SECTION("moved") {
    fs::rename(folder / "run", folder / "other");
    const std::string other = fs::canonical(folder / "other");
    for (const std::string& line : problems())
      CHECK(line ==
            (folder / "run").string() + ": was moved to " + other +
                " while the run was written, and what was to follow is lost; go on with it: scree resume " +
                other);
    CHECK(text_of(folder / "other/written.txt") == "run.json\n");
  }
  SECTION("removed, and its name taken by another") {
    fs::remove_all(folder / "run");
    RunDirectory second(folder / "run", Existing::refuse);
    second.create();
    second.write_file("run.json", "other");
    for (const std::string& line : problems())
      CHECK_THAT(line, Catch::Contains("run: it or its file .lock was removed while the run was written"));
    CHECK(text_of(folder / "run/run.json") == "other");
    CHECK(text_of(folder / "run/written.txt") == "run.json\n");
  }
  SECTION("removed") {
    fs::remove_all(folder / "run");
    for (const std::string& line : problems())
      CHECK_THAT(line, Catch::EndsWith("the results so far; start it again"));
    CHECK_FALSE(fs::exists(folder / "run"));
  }
}

TEST_CASE("a file system without locks is warned of", "[run]") {
  const TemporaryFolder folder;
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& line) { warnings.push_back(line); };
  RunDirectory locked(folder / "run", Existing::refuse);
  locked.take();
  locked.report_lock(warn);
  CHECK(warnings.empty());
  no_locks = true;
  RunDirectory unlocked(folder / "other", Existing::refuse);
  unlocked.take();
  no_locks = false;
  unlocked.report_lock(warn);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Catch::Contains("other: its file system has no locks, so that another process may replace"));
}

TEST_CASE("a directory in the place of a file is named, and not a full disk", "[run]") {
  const TemporaryFolder folder;
  RunDirectory directory(folder / "run", Existing::refuse);
  directory.create();
  fs::create_directories(folder / "run/run.json.part");
  CHECK_THAT(
      failure([&] { directory.write_file("run.json", "{}"); }),
      Catch::EndsWith(
          "run/run.json.part: is a directory in the place of a file; move it elsewhere, or give another --out"));
  fs::remove(folder / "run/run.json.part");
  directory.write_file("run.json", "{}");
  SpareRoom room;
  room.reserve(directory, "run.json");
  room.release();
  fs::create_directories(folder / "run/.room");
  CHECK_THAT(failure([&] { room.reserve(directory, "run.json"); }),
             Catch::Contains("run/.room: is a directory in the place of a file"));
}
