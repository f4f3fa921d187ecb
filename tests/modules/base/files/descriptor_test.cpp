#include "temporary_folder.hpp"

#include <cerrno>
#include <fcntl.h>

#include <catch2/catch.hpp>

#include <scree/files/descriptor.hpp>

using namespace scree::files;
using scree::test::TemporaryFolder;
using scree::test::text_of;
namespace fs = std::filesystem;

TEST_CASE("a descriptor is closed once, at the end of the scope that has it", "[files]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "a";
  const auto is_open = [](int number) { return fcntl(number, F_GETFD) != -1; };
  int number = -1;
  {
    Descriptor first = create_file(path.c_str());
    number = first.get();
    Descriptor second(std::move(first));
    CHECK_FALSE(first.is_open());
    CHECK(second.get() == number);
    CHECK(is_open(number));
    first = std::move(second);
    CHECK(first.get() == number);
  }
  CHECK_FALSE(is_open(number));
  Descriptor kept = create_file(path.c_str());
  number = kept.release();
  kept = Descriptor();
  CHECK(is_open(number));
  close(number);
}

TEST_CASE("a file is created empty in the place of another, and of a link instead of behind it", "[files]") {
  const TemporaryFolder folder;
  const fs::path other = folder.write("other", "kept"), path = folder / "a";
  fs::create_symlink(other, path);
  CHECK_FALSE(append_file(path.c_str()).is_open());
  const Descriptor file = create_file(path.c_str());
  CHECK(write_all(file, "new") == 0);
  CHECK(text_of(other) == "kept");
  CHECK(text_of(path) == "new");
  CHECK(write_all(append_file(path.c_str()), " and more") == 0);
  CHECK(text_of(path) == "new and more");
  CHECK_FALSE(create_file((folder / "none/a").c_str()).is_open());
  CHECK(errno == ENOENT);
}

TEST_CASE("an open file is told from another that has its name by now", "[files]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "a", moved = folder / "b";
  const Descriptor file = create_file(path.c_str());
  CHECK(is_at(file, path.c_str()));
  fs::rename(path, moved);
  CHECK_FALSE(is_at(file, path.c_str()));
  fs::create_symlink(moved, path);
  CHECK_FALSE(is_at(file, path.c_str()));
  CHECK(is_at(file, moved.c_str()));
}

TEST_CASE("bytes that cannot be written give the reason", "[files]") {
  CHECK(write_all(Descriptor(open("/dev/full", O_WRONLY | O_CLOEXEC)), "a") == ENOSPC);
  CHECK(write_all(Descriptor(), "a") == EBADF);
  CHECK(write_all(Descriptor(), "") == 0);
}
