#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include "opened_file.hpp"
#include "sample_state.hpp"
#include "temporary_folder.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <new>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/state_file/state_file.hpp>

using namespace scree;
using namespace scree::test;

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

TEST_CASE("A state is neither written nor read where HDF5 has no memory", "[load_backend]") {
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
