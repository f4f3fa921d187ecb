#include "run_support.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <scree/run/result_kind.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

std::string refused_at(const fs::path& path, RunDirectory::Existing existing) {
  return message([&] { RunDirectory(path, existing); });
}

}  // namespace

TEST_CASE("a run that failed can go on if it has a state, and the refusal of another says so", "[run]") {
  const TemporaryFolder folder;
  const fs::path run = folder / "run";
  {
    RunDirectory first(run, RunDirectory::Existing::refuse);
    first.create();
    first.write_file("run.json", "{\"status\": \"failed\"}");
  }
  CHECK_THAT(refused_at(run, RunDirectory::Existing::refuse),
             Catch::EndsWith("contains a run; give another --out, or --overwrite to replace it"));
  fs::create_directory(run / "checkpoint");
  folder.write("run/checkpoint/step_1.h5", "");
  CHECK_THAT(refused_at(run, RunDirectory::Existing::refuse),
             Catch::Contains("go on with it: scree resume " + run.string()));
}

TEST_CASE("a run directory with foreign files or another run is not overwritten", "[run]") {
  const TemporaryFolder folder;
  folder.write("file", "x");
  CHECK(refused_at(folder / "file", RunDirectory::Existing::replace)
            .ends_with("exists and is not a directory; give another --out"));
  CHECK(refused_at(folder / "file/below", RunDirectory::Existing::replace)
            .find("file is not a writable directory); give another --out") != std::string::npos);
  CHECK(refused_at(folder.path(), RunDirectory::Existing::replace)
            .ends_with("contains files that are not part of a scree run; give another --out"));
  fs::create_directories(folder / "run");
  CHECK(refused_at(folder / "run", RunDirectory::Existing::refuse) == "no error");
  fs::permissions(folder / "run", fs::perms::none);
  const bool barred = access((folder / "run").c_str(), R_OK) != 0;  // nothing is, for root
  CHECK((!barred ||
         refused_at(folder / "run", RunDirectory::Existing::replace)
             .ends_with("cannot be read (Permission denied); check its permissions, or give another --out")));
  fs::permissions(folder / "run", fs::perms::owner_all);
  // Files left by a run that is killed at its start.
  folder.write("run/run.json.part", "{");
  folder.write("run/.lock", "");
  folder.write("run/written.txt", "run.json\nscen");
  CHECK(refused_at(folder / "run", RunDirectory::Existing::refuse) == "no error");
  RunDirectory(folder / "run", RunDirectory::Existing::refuse).create();
  CHECK(fs::is_empty(folder / "run"));
  folder.write("run/run.json", "{}");
  for (const auto existing : {RunDirectory::Existing::refuse, RunDirectory::Existing::replace})
    CHECK(
        refused_at(folder / "run", existing)
            .ends_with(
                "contains a run without written.txt, the list of its files, so that it can be neither replaced nor resumed; "
                "move it elsewhere, or give another --out"));
  folder.write("run/written.txt", "run.json\n");
  CHECK(refused_at(folder / "run", RunDirectory::Existing::refuse).ends_with("or --overwrite to replace it"));
  CHECK(refused_at(folder / "run", RunDirectory::Existing::replace) == "no error");
}
