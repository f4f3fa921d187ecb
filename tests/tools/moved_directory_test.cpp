#include "program.hpp"

using namespace scree::test;

TEST_CASE("a run whose directory is moved or removed ends at once and says what is lost", "[tools]") {
  const std::string endless = with(discs, "duration = 1e-4", "duration = 5000");
  const auto after = [](const Workspace& w, const std::string& change) {
    return w.shell("'" SCREE_TEST_PROGRAM
                   "' run scene.toml --out out --quiet &\nrun=$!\n"
                   "(sleep 30; kill -KILL $run) > /dev/null 2>&1 &\ntrap \"kill $!\" EXIT\n"
                   "until test -s out/series/energy.csv; do sleep 0.05; done; " +
                   change + "; wait $run");
  };
  const Workspace moved(endless);
  const Outcome elsewhere = after(moved, "mv out other");
  CHECK(elsewhere.status == 1);
  CHECK_THAT(elsewhere.err, Catch::StartsWith("scree: out: was moved to ") &&
                                Catch::Contains("/other while the run was written") &&
                                Catch::Contains("; go on with it: scree resume "));
  CHECK_FALSE(moved.has("out"));
  CHECK(moved.text("other/written.txt").starts_with("run.json\n"));
  CHECK(moved.record("other")["status"] == "running");

  const Workspace removed(endless);
  const Outcome gone = after(removed, "rm -rf out");
  CHECK(gone.status == 1);
  CHECK(gone.err ==
        "scree: out: it or its file .lock was removed while the run was written, and with it the results so "
        "far; start it again\n");
  CHECK_FALSE(removed.has("out"));
}

// A pipe is opened by the shell once the program reads it, which then waits for the scene.
TEST_CASE("a program whose file is replaced before it loads its libraries says so", "[tools]") {
  const Workspace w;
  const Outcome replaced = w.shell(
      "tree=$(dirname \"$(dirname '" SCREE_TEST_PROGRAM "')\")\nmkdir -p copy/bin && cp '" SCREE_TEST_PROGRAM
      "' copy/bin/scree && ln -s \"$tree/lib\" copy/lib && ln -s \"$tree/plugins\" copy/plugins\n"
      "mkfifo pipe.toml\ncopy/bin/scree run pipe.toml --out out --quiet &\nrun=$!\n"
      "exec 3> pipe.toml && rm copy/bin/scree && cat scene.toml >&3 && exec 3>&- && wait $run");
  CHECK(replaced.status == 1);  // once the run has begun
  CHECK(replaced.err ==
        "scree: the file of this program was replaced or removed while it runs; repeat the command, which "
        "goes on with the new one\n");
}
