#include "temporary_folder.hpp"

#include <cerrno>

#include <catch2/catch.hpp>

#include <scree/files/text_file.hpp>

using namespace scree;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

template <class Failure = Error, class Action>
Failure failure_of(Action&& action) {
  try {
    action();
  } catch (const Failure& failure) {
    return failure;
  }
  throw std::logic_error("no error");
}

}  // namespace

TEST_CASE("a file is read whole, up to the limit") {
  const TemporaryFolder folder;
  const std::string text(200000, 'x');
  const fs::path path = folder.write("long.txt", text + '\0');
  CHECK(files::read_text(path) == text + '\0');
  CHECK(files::read_text(path, text.size() + 1).size() == text.size() + 1);
  const auto failure = failure_of<files::ReadError>([&] { files::read_text(path, text.size()); });
  CHECK(failure.code() == EFBIG);
  CHECK(files::read_text(folder.write("empty.txt", "")).empty());
}

TEST_CASE("a file that cannot be read is refused with its path, a cure and the code of the system") {
  const TemporaryFolder folder;
  const auto absent = failure_of<files::ReadError>([&] { files::read_text(folder / "absent.txt"); });
  CHECK(absent.what() == (folder / "absent.txt").string() + ": there is no such file; check the path");
  CHECK(absent.code() == ENOENT);
  const auto directory = failure_of<files::ReadError>([&] { files::read_text(folder.path()); });
  CHECK(directory.what() == folder.path().string() + ": is not a regular file; give a text file");
  CHECK(failure_of<files::ReadError>([&] { files::read_text(folder.path(), 10); }).code() == EISDIR);
  CHECK(failure_of<files::ReadError>([] { files::read_text("/dev/zero"); }).code() == EINVAL);
  CHECK(failure_of<files::ReadError>([] { files::read_text("/dev/zero", 10); }).code() == EFBIG);
}

TEST_CASE("a file is written whole or not at all") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a.txt", "before");
  files::write_atomically(path, "after\n");
  CHECK(text_of(path) == "after\n");
  CHECK_FALSE(fs::exists(path.string() + files::part_suffix));

  const fs::path nowhere = folder / "no" / "b.txt";
  const Error absent = failure_of([&] { files::write_atomically(nowhere, "b"); });
  CHECK(absent.what() ==
        nowhere.string() + ": cannot be opened for writing; check that its folder exists and is writable");
  CHECK(absent.status() == ExitStatus::failure);

  const fs::path taken = folder / "directory";
  fs::create_directories(taken / "below");
  CHECK_THROWS_AS(files::write_atomically(taken, "c"), Error);
  CHECK_FALSE(fs::exists(taken.string() + files::part_suffix));
}

TEST_CASE("the folder of a file is created, but none above") {
  const TemporaryFolder folder;
  for (const char* text : {"first", "second"}) {
    files::write_in_folder(folder / "new/a.txt", text);
    CHECK(text_of(folder / "new/a.txt") == text);
  }
  CHECK_THROWS_AS(files::write_in_folder(folder / "removed/new/a.txt", "a"), files::WriteError);
  CHECK_FALSE(fs::exists(folder / "removed"));
}

TEST_CASE("a link under the temporary name leads nowhere") {
  const TemporaryFolder folder;
  const fs::path other = folder.write("other.txt", "kept"), path = folder / "a.txt";
  fs::create_symlink(other, path.string() + files::part_suffix);
  files::write_atomically(path, "text");
  CHECK(text_of(other) == "kept");
  CHECK(text_of(path) == "text");
}
