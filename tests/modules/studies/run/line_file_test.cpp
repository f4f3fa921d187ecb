#include "document_support.hpp"
#include "temporary_folder.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/run/line_file.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

TEST_CASE("lines are in the file once they are flushed, or many wait", "[run]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "new/a.csv";  // with its folder
  LineFile file(path);
  file.add("one\n");
  CHECK(text_of(path).empty());
  CHECK(file.bytes() == 0);
  file.flush();
  CHECK(text_of(path) == "one\n");
  CHECK(file.bytes() == 4);
  const std::string line(999, 'x');
  for (int k = 0; k < 100; ++k) file.add(line + "\n");
  CHECK(text_of(path).size() > 50'000);
  CHECK(text_of(path).size() == file.bytes());
  file.flush();
  CHECK(file.bytes() == 4 + 100 * 1000);
}

TEST_CASE("a file goes on behind a whole line, and keeps what follows until it is cut", "[run]") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a.csv", "one\ntwo\nthr");
  LineFile file(path, 4);
  CHECK(text_of(path) == "one\ntwo\nthr");
  file.cut();
  file.add("other\n");
  file.flush();
  CHECK(text_of(path) == "one\nother\n");
}

TEST_CASE("a file that is not as it was up to its former end is refused and left as it is", "[run]") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a.csv", "one\ntwo\n");
  const auto refused = [](const fs::path& file, std::uint64_t bytes) {
    return message([&] { LineFile(file, bytes); });
  };
  for (const std::uint64_t bytes : {0, 2, 7})
    CHECK_THAT(refused(path, bytes),
               Catch::Contains("a.csv: has no line that ends where the last one ended"));
  CHECK_THAT(refused(path, 9), Catch::Contains("a.csv: is shorter than when the checkpoint was written"));
  CHECK_THAT(refused(folder / "none.csv", 4), Catch::Contains("none.csv: cannot be opened"));
  fs::create_symlink(path, folder / "link.csv");
  CHECK_THAT(refused(folder / "link.csv", 4), Catch::Contains("link.csv: cannot be opened"));
  CHECK(text_of(path) == "one\ntwo\n");
}

TEST_CASE("lines for a file that was moved are lost and told", "[run]") {
  const TemporaryFolder folder;
  LineFile file(folder / "a.csv");
  file.add("one\n");
  fs::rename(folder / "a.csv", folder / "b.csv");
  CHECK_THROWS_WITH(file.flush(), Catch::Contains("a.csv: was moved or removed while it was written"));
  CHECK(text_of(folder / "b.csv").empty());
}
