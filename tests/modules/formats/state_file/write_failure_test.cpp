#include "opened_file.hpp"
#include "sample_state.hpp"
#include "temporary_folder.hpp"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <memory>
#include <new>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::test;
using Catch::Matchers::Contains;

namespace {

// Limits the size of files while it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_ = {};
};

State large_state() {
  State state = sample_state();
  state.put("large", {std::vector<double>(100'000, 1.5), {100'000}, "m"});
  return state;
}

// What write_state says: one line for a failure, with a cure.
std::string failure(const std::filesystem::path& file, const State& state) {
  try {
    state_file::write_state(file, state);
  } catch (const Error& error) {
    const std::string line = error.what();
    CHECK(error.status() == ExitStatus::failure);
    CHECK(line.starts_with(file.string() + ": cannot be written ("));
    CHECK(line.find("; ") != line.npos);
    CHECK(line.find('\n') == line.npos);
    return line;
  }
  return "";
}

std::size_t open_files() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

}  // namespace

TEST_CASE("A state that does not fit leaves the earlier one whole and no part behind", "[write_failure]") {
  const TemporaryFolder folder;
  state_file::write_state(folder / "a.h5", sample_state());
  const std::string before = text_of(folder / "a.h5");
  state_file::write_state(folder / "large.h5", large_state());
  const std::size_t whole = std::filesystem::file_size(folder / "large.h5"), open = open_files();
  for (const std::size_t bytes :
       {std::size_t(0), std::size_t(100), std::size_t(512), std::size_t(3000), whole / 2, whole - 1}) {
    INFO(bytes);
    {
      const FileSizeLimit limit(bytes);
      CHECK_THAT(failure(folder / "a.h5", large_state()), Contains("File too large"));
    }
    CHECK(text_of(folder / "a.h5") == before);
    CHECK_FALSE(std::filesystem::exists(folder / "a.h5.part"));
  }
  CHECK(open_files() == open);
  state_file::write_state(folder / "a.h5", large_state());
  CHECK(state_file::read_state(folder / "a.h5") == large_state());
}

TEST_CASE("HDF5 prints nothing of a failure, in whatever thread it happens", "[write_failure]") {
  const TemporaryFolder folder;
  const int output = open((folder / "stderr").c_str(), O_CREAT | O_WRONLY, 0600), before = dup(STDERR_FILENO);
  std::string line;
  {
    dup2(output, STDERR_FILENO);
    std::thread([&] {
      const FileSizeLimit limit(3000);
      line = failure(folder / "a.h5", large_state());
    }).join();
    dup2(before, STDERR_FILENO);
  }
  close(output), close(before);
  CHECK_THAT(line, Contains("File too large"));
  CHECK(text_of(folder / "stderr") == "");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace {

// While it lives, memory ends a little above what the program has.
class MemoryLimit {
 public:
  MemoryLimit() {
    getrlimit(RLIMIT_AS, &usual_);
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit scarce = {rlim_t(pages) * rlim_t(sysconf(_SC_PAGESIZE)) + (rlim_t(1) << 20),
                           usual_.rlim_max};
    pieces_.reserve(1 << 16);
    setrlimit(RLIMIT_AS, &scarce);
    while (pieces_.size() < pieces_.capacity())
      if (char* const piece = new (std::nothrow) char[4000])
        pieces_.emplace_back(piece);
      else
        break;
    pieces_.resize(pieces_.size() - std::min<std::size_t>(pieces_.size(), 100));
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &usual_); }

 private:
  rlimit usual_ = {};
  std::vector<std::unique_ptr<char[]>> pieces_;
};

}  // namespace

TEST_CASE("A state is neither written nor read where HDF5 has no memory", "[write_failure]") {
  const TemporaryFolder folder;
  const auto file = folder / "a.h5";
  state_file::write_state(file, sample_state());
  const std::string before = text_of(file);
  const state_file::OpenedFile opened(file);
  const State other = odd_state();
  std::string written, read;
  {
    const MemoryLimit limit;
    try {
      state_file::write_state(file, other);
    } catch (const Error& error) {
      written = error.what();
    }
    try {
      opened.state();
    } catch (const Error& error) {
      read = error.what();
    }
  }
  CHECK(
      written ==
      file.string() +
          ": there is no memory for HDF5, which writes and reads states; give the program more (ulimit -v)");
  CHECK(read == written);
  CHECK(text_of(file) == before);
}
#endif

TEST_CASE("A state is not written where there is no folder or no permission", "[write_failure]") {
  const TemporaryFolder folder;
  CHECK_THAT(failure(folder / "none/a.h5", sample_state()), Contains("No such file or directory"));
  CHECK_THAT(failure(folder.write("file", "") / "a.h5", sample_state()), Contains("Not a directory"));
  CHECK_THAT(failure("/proc/a.h5", sample_state()),
             Contains("; check that its folder exists and is writable"));
  std::filesystem::create_directory(folder / "a.h5");
  CHECK_THAT(failure(folder / "a.h5", sample_state()), Contains("Is a directory"));
  CHECK_FALSE(std::filesystem::exists(folder / "a.h5.part"));
}

TEST_CASE("A link of the name of the part is replaced and not followed", "[write_failure]") {
  const TemporaryFolder folder;
  const auto other = folder.write("other", "precious");
  std::filesystem::create_symlink(other, folder / "a.h5.part");
  state_file::write_state(folder / "a.h5", sample_state());
  CHECK(text_of(other) == "precious");
  CHECK(std::filesystem::is_regular_file(std::filesystem::symlink_status(folder / "a.h5")));
  CHECK_FALSE(std::filesystem::exists(folder / "a.h5.part"));
}
