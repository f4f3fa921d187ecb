#include "temporary_folder.hpp"

#include <map>
#include <sys/wait.h>

#include <catch2/catch.hpp>

#include <scree/campaign/process_pool.hpp>

using scree::campaign::ProcessPool;
using scree::test::TemporaryFolder;
using scree::test::text_of;

namespace {

// Waits for all processes; returns how each ended, by id.
std::map<std::size_t, std::string> end_of_all(ProcessPool& pool) {
  std::map<std::size_t, std::string> ends;
  while (pool.size() > 0)
    for (const ProcessPool::Ended& ended : pool.wait(10)) ends[ended.id] = ended.how;
  return ends;
}

std::vector<std::string> shell(const std::string& text) { return {"/bin/sh", "-c", text}; }

}  // namespace

TEST_CASE("processes run concurrently, write their logs and report how they ended", "[campaign]") {
  const TemporaryFolder folder;
  ProcessPool pool;
  // Each waits for the other, so they would not end if run one after the other.
  const std::string a = (folder / "a").string(), b = (folder / "b").string();
  pool.start(1, shell("mkfifo " + a + " && cat " + b + "; echo first >&2"), folder / "1.txt");
  pool.start(2, shell("until test -p " + a + "; do :; done; echo hand > " + b + "; exit 3"),
             folder / "2.txt");
  pool.start(3, shell("kill -9 $$"), folder / "3.txt");
  pool.start(4, {"/no/such/program"}, folder / "4.txt");
  pool.start(5, shell("cat"), folder / "5.txt");  // standard input is empty
  const auto ends = end_of_all(pool);
  CHECK(ends.at(1).empty());
  CHECK(ends.at(2) == "exit status 3");
  CHECK(ends.at(3) == "killed by signal 9 (Killed)");
  CHECK(ends.at(4) == "exit status 127");
  CHECK(ends.at(5).empty());
  CHECK(text_of(folder / "1.txt").ends_with("first\n"));
  CHECK(text_of(folder / "4.txt").starts_with("scree: the program cannot be started; "));
}

TEST_CASE("a signal reaches every process of a pool, and the pool terminates running processes at its end",
          "[campaign]") {
  const TemporaryFolder folder;
  {
    ProcessPool pool;
    for (std::size_t id : {0, 1}) pool.start(id, {"/bin/sleep", "1000"}, folder / "log.txt");
    CHECK(pool.wait(0).empty());
    pool.signal(SIGINT);
    const auto ends = end_of_all(pool);
    for (std::size_t id : {0, 1}) CHECK(ends.at(id) == "killed by signal 2 (Interrupt)");
    pool.start(2, {"/bin/sleep", "1000"}, folder / "log.txt");
  }
  CHECK(waitpid(-1, nullptr, WNOHANG) < 0);
}

TEST_CASE("a log that cannot be written is an error", "[campaign]") {
  ProcessPool pool;
  CHECK_THROWS_WITH(pool.start(0, shell("true"), "/no/such/folder/log.txt"),
                    Catch::Contains("/no/such/folder/log.txt: cannot be written"));
  CHECK(pool.size() == 0);
}
