#include "temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>
#include <scree/files/text_reader.hpp>

using namespace scree::files;
using scree::test::TemporaryFolder;

namespace {

// The lines of a text as a reader gives them, "+" after each that ends with a line break; or the error.
std::string lines_of(TextReader reader) {
  std::string all;
  while (reader.next()) all += std::string(reader.line()) + (reader.is_whole() ? "+" : "");
  return all;
}

template <class Read>
std::string error_of(const Read& read) {
  try {
    read();
  } catch (const scree::Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a text in memory and the same text in a file are read alike", "[text_reader]") {
  const TemporaryFolder folder;
  const auto of_file = [&](const std::string& text) { return lines_of(TextReader(folder.write("t", text))); };
  for (const std::string text : {"", "a", "a\n",
                                 "\xef\xbb\xbf"
                                 "a\r\n\nb",
                                 "\n\n", "# c\n1 2\n"}) {
    CAPTURE(text);
    CHECK(of_file(text) == lines_of(TextReader(text, "t")));
  }
  CHECK(of_file("a\r\nb") == "a+b");
  for (const std::string& text :
       {std::string("a\nb\0c\n", 6), std::string("\x1f\x8b\x08"), std::string("\x28\xb5\x2f\xfd")}) {
    const std::string file = (folder / "t").string();
    CHECK(error_of([&] { of_file(text); }) == error_of([&] { lines_of(TextReader(text, file)); }));
  }
}

TEST_CASE("a reader goes back to a line", "[text_reader]") {
  TextReader reader("# first\n\n2 b\nlast", "t");
  REQUIRE(reader.next_words());
  CHECK(reader.line_number() == 3);
  const TextReader::Position second = reader.position();
  while (reader.next()) {
  }
  CHECK(reader.line_number() == 4);
  reader.seek(second);
  REQUIRE(reader.next());
  CHECK(reader.line() == "2 b");
  CHECK(reader.words()[1].column == 3);
  CHECK(error_of([&] { reader.number(reader.words()[1], "size"); }) ==
        "t:3:3: size 'b' is not a number; write a number such as 1.5e-3");
}

TEST_CASE("rows of a text have the comments before the header, and an example for one without",
          "[csv_rows]") {
  std::string comments;
  const auto note = [&](const TextReader& comment) { comments += comment.line(); };
  CsvRows rows("# a\n\nx [m],y\n# b\n1,2\n", "t", "x,y", note);
  CHECK(comments == "# a");
  CHECK(rows.row()[0].text == "x [m]");
  REQUIRE(rows.next());
  CHECK(rows.row()[1].column == 3);
  CHECK_FALSE(rows.next());
  CHECK(error_of([&] { CsvRows("# a\n", "t", "x,y", note); }) ==
        "t:1:1: there is no header; name the columns in the first line, such as 'x,y'");
}
