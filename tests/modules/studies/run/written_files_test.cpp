#include "temporary_folder.hpp"

#include <thread>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/run/written_files.hpp>

using namespace scree;
using namespace scree::run;
using namespace scree::test;
namespace fs = std::filesystem;

namespace {

void write(WrittenFiles& files, const std::string& name) {
  const fs::path path = files.add(name);
  fs::create_directories(path.parent_path());
  std::ofstream(path) << name;
}

}  // namespace

TEST_CASE("files are listed once, before they are there", "[run]") {
  const TemporaryFolder folder;
  WrittenFiles files(folder.path());
  CHECK(files.size() == 0);
  CHECK(files.add("series/a.csv") == folder / "series/a.csv");
  CHECK(text_of(folder / "written.txt") == "series/a.csv\n");
  write(files, "series/a.csv");
  files.add("series/a.csv");
  CHECK(files.size() == 13);
  CHECK(fs::file_size(folder / "written.txt") == 13);
  CHECK(WrittenFiles(folder.path()).contains("series/a.csv"));
  for (const char* odd : {"", "/etc/a", "../a", "a/../b", "a\nb"}) CHECK_THROWS_AS(files.add(odd), Error);
}

TEST_CASE("a return removes what was listed since, but for what was listed before", "[run]") {
  const TemporaryFolder folder;
  WrittenFiles files(folder.path());
  write(files, "run.json");
  write(files, "images/1.png");
  const std::uint64_t size = files.size();
  write(files, "images/2.png");
  write(files, "charts/c.png");
  std::ofstream(folder / "written.txt", std::ios::app) << "run.json\n";
  files.return_to(size);
  CHECK(files.size() == size);
  CHECK(text_of(folder / "written.txt") == "run.json\nimages/1.png\n");
  CHECK(fs::exists(folder / "run.json"));
  CHECK(fs::exists(folder / "images/1.png"));
  CHECK_FALSE(fs::exists(folder / "images/2.png"));
  CHECK_FALSE(fs::exists(folder / "charts"));
  CHECK_FALSE(files.contains("images/2.png"));
  for (const std::uint64_t nowhere : {size - 1, size + 1}) CHECK_THROWS_AS(files.return_to(nowhere), Error);
}

TEST_CASE(
    "states do not count, as their number depends on the wall time, and return with the line before them",
    "[run]") {
  const TemporaryFolder folder;
  WrittenFiles files(folder.path());
  write(files, "run.json");
  const std::uint64_t size = files.size();
  write(files, "checkpoint/step_1.h5");
  CHECK(files.size() == size);
  CHECK(WrittenFiles(folder.path()).size() == size);
  write(files, "images/2.png");
  write(files, "checkpoint/step_3.h5");
  files.return_to(size);
  CHECK(files.size() == size);
  CHECK(text_of(folder / "written.txt") == "run.json\ncheckpoint/step_1.h5\n");
  CHECK(fs::exists(folder / "checkpoint/step_1.h5"));
  CHECK_FALSE(fs::exists(folder / "checkpoint/step_3.h5"));
  write(files, "images/2.png");
  CHECK(text_of(folder / "written.txt") == "run.json\ncheckpoint/step_1.h5\nimages/2.png\n");
}

TEST_CASE("a line that a killed run began is not followed, and lines of others are kept", "[run]") {
  const TemporaryFolder folder;
  folder.write("written.txt", "run.json\nimag");
  folder.write("imag", "mine");
  WrittenFiles files(folder.path());
  CHECK_FALSE(files.contains("imag"));
  files.add("a.csv");
  CHECK(text_of(folder / "written.txt") == "run.json\na.csv\n");
  std::ofstream(folder / "written.txt", std::ios::app) << "images/of_render.png\n";
  files.add("b.csv");
  CHECK(files.contains("images/of_render.png"));
  CHECK(text_of(folder / "written.txt") == "run.json\na.csv\nimages/of_render.png\nb.csv\n");
  files.return_to(0);
  CHECK(text_of(folder / "imag") == "mine");
  CHECK_FALSE(fs::exists(folder / "written.txt"));
}

TEST_CASE("files in a folder that is a link are not written", "[run]") {
  const TemporaryFolder folder;
  fs::create_directories(folder / "run");
  fs::create_directory_symlink(folder.path(), folder / "run/images");
  WrittenFiles files(folder / "run");
  CHECK_THROWS_WITH(files.add("images/1.png"),
                    Catch::Contains("run/images/1.png: its folder is a symbolic link"));
  CHECK(files.size() == 0);
}

TEST_CASE("a list that is a link is neither read nor written", "[run]") {
  const TemporaryFolder folder;
  folder.write("list", "run.json\n");
  fs::create_directory(folder / "run");
  WrittenFiles before(folder / "run");
  fs::create_symlink(folder / "list", folder / "run/written.txt");
  CHECK_THROWS_WITH(WrittenFiles(folder / "run"), Catch::Contains("run/written.txt: is not a file"));
  CHECK_THROWS_AS(before.add("a.csv"), Error);
  CHECK(text_of(folder / "list") == "run.json\n");
}

TEST_CASE("of two that add lines at once, as render beside a run, neither loses any", "[run]") {
  const TemporaryFolder folder;
  constexpr int lines = 500;
  const auto add = [&](const std::string& kind) {
    WrittenFiles files(folder.path());
    for (int k = 0; k < lines; ++k) files.add(kind + std::to_string(k));
  };
  std::thread other([&] { add("images/"); });
  add("snapshots/");
  other.join();
  const WrittenFiles files(folder.path());
  int found = 0;
  for (const std::string kind : {"images/", "snapshots/"})
    for (int k = 0; k < lines; ++k) found += files.contains(kind + std::to_string(k));
  CHECK(found == 2 * lines);
}

TEST_CASE("a file that is put beside a run that goes on is listed whenever it is there", "[run]") {
  const TemporaryFolder folder;
  WrittenFiles files(folder.path());
  write(files, "run.json");
  const std::uint64_t size = files.size();
  WrittenFiles of_render(folder.path());
  of_render.put("images/1.png", "first");
  files.return_to(size);
  CHECK_FALSE(fs::exists(folder / "images"));
  files.add("images/2.png");  // the list is as long as before
  of_render.put("images/1.png", "second");
  CHECK(text_of(folder / "images/1.png") == "second");
  CHECK(text_of(folder / "written.txt") == "run.json\nimages/2.png\nimages/1.png\n");
  CHECK(files.add("images/1.png") == folder / "images/1.png");
}

TEST_CASE("a list that was removed or shortened is not filled up with zeros", "[run]") {
  const TemporaryFolder folder;
  WrittenFiles files(folder.path());
  files.add("a.csv");
  files.add("b.csv");
  SECTION("shortened") {
    fs::resize_file(folder / "written.txt", 6);
    files.add("c.csv");
    CHECK(text_of(folder / "written.txt") == "a.csv\nc.csv\n");
  }
  SECTION("removed") {
    fs::remove(folder / "written.txt");
    files.add("c.csv");
    CHECK(text_of(folder / "written.txt") == "c.csv\n");
  }
}

TEST_CASE("names of states that were removed do not fill the list", "[run]") {
  const TemporaryFolder folder;
  WrittenFiles files(folder.path());
  write(files, "run.json");
  const std::uint64_t size = files.size();
  write(files, "images/1.png");
  constexpr int states = 1000;
  const auto name = [](int k) { return "checkpoint/step_" + std::to_string(k) + ".h5"; };
  for (int k = 0; k < states; ++k) {
    write(files, name(k));
    if (k > 1) fs::remove(folder / name(k - 2));
  }
  CHECK(fs::file_size(folder / "written.txt") < 100 * name(states).size());
  for (const std::string& kept : {std::string("run.json"), name(states - 2), name(states - 1)})
    CHECK(WrittenFiles(folder.path()).contains(kept));
  files.return_to(size);
  CHECK(text_of(folder / "written.txt") == "run.json\n");
  CHECK_FALSE(fs::exists(folder / "checkpoint"));
}
