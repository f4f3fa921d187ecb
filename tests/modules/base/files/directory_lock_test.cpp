#include "temporary_folder.hpp"

#include <atomic>
#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/files/directory_lock.hpp>

using namespace scree;
using scree::files::DirectoryLock;
namespace fs = std::filesystem;

TEST_CASE("a directory is locked by one at a time, and made and removed with the lock", "[files]") {
  const test::TemporaryFolder folder;
  {
    const auto first = DirectoryLock::take(folder / "a/b");
    REQUIRE(first);
    CHECK(DirectoryLock::is_held(folder / "a/b"));
    CHECK_FALSE(DirectoryLock::take(folder / "a/b"));
    CHECK_FALSE(DirectoryLock::take_new(folder / "a/b"));
    CHECK_FALSE(DirectoryLock::is_held(folder / "a"));
  }
  CHECK(fs::is_empty(folder.path()));
  CHECK_FALSE(DirectoryLock::is_held(folder / "a/b"));
}

TEST_CASE("a directory with content stays when its lock is released", "[files]") {
  const test::TemporaryFolder folder;
  {
    const auto lock = DirectoryLock::take_new(folder / "a");
    folder.write("a/letter.txt", "dear");
  }
  CHECK(fs::exists(folder / "a/letter.txt"));
  CHECK_FALSE(fs::exists(folder / "a/.lock"));
  CHECK(DirectoryLock::take(folder / "a"));
}

TEST_CASE("the lock of a process that is killed can be taken", "[files]") {
  const test::TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    const auto lock = DirectoryLock::take(folder / "a");
    raise(lock ? SIGKILL : SIGTERM);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WTERMSIG(status) == SIGKILL);
  CHECK(fs::exists(folder / "a/.lock"));
  CHECK_FALSE(DirectoryLock::is_held(folder / "a"));
  CHECK(DirectoryLock::take(folder / "a"));
}

TEST_CASE("a lock outlives the directory it was in, and leaves another's alone", "[files]") {
  const test::TemporaryFolder folder;
  auto old = DirectoryLock::take(folder / "a");
  fs::remove_all(folder / "a");
  const auto fresh = DirectoryLock::take(folder / "a");
  REQUIRE(fresh);
  old.reset();
  CHECK(DirectoryLock::is_held(folder / "a"));
  CHECK_FALSE(DirectoryLock::take(folder / "a"));
}

TEST_CASE("a link in place of the lock file is not followed", "[files]") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "a");
  fs::create_symlink(folder / "outside", folder / "a/.lock");
  CHECK_THROWS_WITH(DirectoryLock::take(folder / "a"), Catch::EndsWith("give another --out"));
  CHECK_FALSE(fs::exists(folder / "outside"));
}

TEST_CASE("of threads that take and release a directory that comes and goes, never two have it",
          "[files][threads]") {
  const test::TemporaryFolder folder;
  std::atomic<int> holders = 0, most = 0, taken = 0;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&] {
      for (int n = 0; n < 500; ++n) {
        const auto lock = DirectoryLock::take(folder / "a/b");
        if (!lock) continue;
        const int now = ++holders;
        if (now > most) most = now;
        ++taken;
        --holders;
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(most == 1);
  CHECK(taken > 0);
}

TEST_CASE("a lock tells whether its directory is in place, and where else it is", "[files]") {
  const test::TemporaryFolder folder;
  const auto lock = DirectoryLock::take(folder / "a");
  CHECK(lock->is_current());
  CHECK(lock->excludes());
  fs::rename(folder / "a", folder / "b");
  CHECK_FALSE(lock->is_current());
  CHECK(lock->moved_to() == fs::canonical(folder / "b"));
  fs::create_directory(folder / "a");
  folder.write("a/.lock", "");
  CHECK_FALSE(lock->is_current());
  fs::remove_all(folder / "b");
  CHECK(lock->moved_to().empty());
}
