#include "document_support.hpp"
#include "temporary_folder.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>

#include <scree/run/run_directory.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

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

TEST_CASE("a run directory with foreign files or another run is not overwritten", "[run]") {
  const TemporaryFolder folder;
  folder.write("file", "x");
  CHECK(reason(folder / "file", Existing::replace)
            .ends_with("exists and is not a directory; give another --out"));
  CHECK(reason(folder / "file/below", Existing::replace)
            .find("file is not a writable directory); give another --out") != std::string::npos);
  CHECK(reason(folder.path(), Existing::replace)
            .ends_with("contains files that are not part of a scree run; give another --out"));
  fs::create_directories(folder / "run");
  CHECK(reason(folder / "run", Existing::refuse) == "no error");
  fs::permissions(folder / "run", fs::perms::none);
  const bool barred = access((folder / "run").c_str(), R_OK) != 0;  // nothing is, for root
  CHECK((!barred ||
         reason(folder / "run", Existing::replace)
             .ends_with("cannot be read (Permission denied); check its permissions, or give another --out")));
  fs::permissions(folder / "run", fs::perms::owner_all);
  // Files left by a run that is killed at its start.
  folder.write("run/run.json.part", "{");
  folder.write("run/.lock", "");
  CHECK(reason(folder / "run", Existing::refuse) == "no error");
  RunDirectory(folder / "run", Existing::refuse).create();
  CHECK(fs::is_empty(folder / "run"));
  folder.write("run/run.json", "{}");
  CHECK(reason(folder / "run", Existing::refuse).ends_with("or --overwrite to replace it"));
  CHECK(reason(folder / "run", Existing::replace) == "no error");
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
            }).ends_with("a/run: another run is running there; wait for it or give another --out"));
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
