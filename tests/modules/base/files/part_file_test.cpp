#include "temporary_folder.hpp"

#include <fstream>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/files/part_file.hpp>

using namespace scree;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

void write(const files::PartFile& file, const std::string& text) {
  REQUIRE(::write(file.descriptor(), text.data(), text.size()) == ssize_t(text.size()));
}

}  // namespace

TEST_CASE("a part file has its name when it is committed, and an earlier file is whole until then",
          "[part_file]") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a", "before");
  {
    files::PartFile file(path);
    write(file, "after");
    CHECK(text_of(path) == "before");
    file.commit();
    CHECK(text_of(path) == "after");
  }
  CHECK(text_of(path) == "after");
  CHECK_FALSE(fs::exists(folder / "a.part"));
}

TEST_CASE("a part file that is not committed is removed", "[part_file]") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a", "before");
  write(files::PartFile(path), "after");
  CHECK(text_of(path) == "before");
  CHECK_FALSE(fs::exists(folder / "a.part"));
}

TEST_CASE("a part that an interrupted program left is replaced", "[part_file]") {
  const TemporaryFolder folder;
  folder.write("a.part", "something longer");
  files::PartFile file(folder / "a");
  write(file, "after");
  file.commit();
  CHECK(text_of(folder / "a") == "after");
}

TEST_CASE("a part file in the working directory needs no folder in its name", "[part_file]") {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  files::PartFile("a").commit();
  fs::current_path(before);
  CHECK(fs::exists(folder / "a"));
}
