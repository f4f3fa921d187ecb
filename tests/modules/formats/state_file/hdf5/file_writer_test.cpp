#include "refusals.hpp"
#include "sample_state.hpp"
#include "temporary_folder.hpp"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <catch2/catch.hpp>

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

std::size_t open_files() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

}  // namespace

TEST_CASE("A state that does not fit leaves the earlier one whole and no part behind", "[file_writer]") {
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

TEST_CASE("HDF5 prints nothing of a failure, in whatever thread it happens", "[file_writer]") {
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

TEST_CASE("Equal states give equal bytes at any time", "[file_writer]") {
  const TemporaryFolder folder;
  state_file::write_state(folder / "a.h5", odd_state());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 counts times in seconds
  state_file::write_state(folder / "b.h5", odd_state());
  CHECK((text_of(folder / "a.h5") == text_of(folder / "b.h5")));  // without printing them
}

TEST_CASE("Numbers lie in the file with the lowest byte first, in one piece", "[file_writer]") {
  const TemporaryFolder folder;
  state_file::write_state(folder / "a.h5", odd_state());
  const hid_t file = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const std::pair<const char*, hid_t> types[] = {{"particles/bodies/position/value", H5T_IEEE_F64LE},
                                                 {"scree/odd/floats", H5T_IEEE_F32LE},
                                                 {"particles/bodies/id", H5T_STD_I64LE},
                                                 {"scree/clock/steps", H5T_STD_U64LE},
                                                 {"particles/bodies/image/value", H5T_STD_I32LE},
                                                 {"particles/bodies/species", H5T_STD_U32LE},
                                                 {"scree/odd/bytes", H5T_STD_U8LE}};
  for (const auto& [path, type] : types) {
    INFO(path);
    const hid_t dataset = H5Dopen2(file, path, H5P_DEFAULT);
    CHECK(H5Tequal(H5Dget_type(dataset), type) > 0);
    CHECK(H5Pget_layout(H5Dget_create_plist(dataset)) == H5D_CONTIGUOUS);
    H5Dclose(dataset);
  }
  H5Fclose(file);
}
