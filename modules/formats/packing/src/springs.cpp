#include "lammps_dump_frames.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/springs.hpp>

namespace scree::packing {

using files::TextReader;
using files::Token;

namespace {

constexpr std::array<std::string_view, 5> spring_columns = {"a", "b", "spring_x", "spring_y", "spring_z"};
constexpr std::size_t not_read = spring_columns.size();
constexpr const char* columns_cure =
    "name the columns in their order, such as springs.columns = [\"a\", \"b\", \"spring_x\", \"spring_y\", "
    "\"spring_z\", \"-\"], where \"-\" is not read";

class SpringReader {
 public:
  SpringReader(TextReader& reader, const SpringOptions& options) : reader_(reader), options_(options) {}

  std::vector<Spring> read() {
    read_head();
    choose_columns();
    while (reader_.next() && !reader_.line().starts_with("ITEM:"))
      if (!reader_.words().empty()) read_spring();
    if (std::int64_t(springs_.size()) != expected_) fail_truncated();
    return std::move(springs_);
  }

 private:
  void read_head();
  void choose_columns();
  void read_spring();
  void check_pair(const Spring& spring);
  [[noreturn]] void fail_truncated();

  TextReader& reader_;
  const SpringOptions& options_;
  std::vector<std::size_t> meaning_;  // of each column: index into spring_columns, or not_read
  std::vector<Spring> springs_;
  std::int64_t expected_ = -1;  // as the head of the frame says
  std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> line_of_;
};

// Up to the line "ITEM: ENTRIES ...".
void SpringReader::read_head() {
  while (reader_.next()) {
    if (reader_.line().starts_with("ITEM: ENTRIES")) break;
    if (reader_.line().starts_with("ITEM: ATOMS"))
      reader_.fail(1, "the dump has atoms and no pairs", "give the output of dump local");
    if (reader_.line().starts_with("ITEM: NUMBER OF ENTRIES") && reader_.next())
      expected_ = reader_.integer(reader_.trimmed(0, reader_.line().size()), "number of entries");
  }
  if (expected_ < 0 || !reader_.line().starts_with("ITEM: ENTRIES")) fail_truncated();
}

void SpringReader::fail_truncated() {
  reader_.fail(1, fmt::format("the frame has {} of {} entries", springs_.size(), expected_),
               "complete the file, or choose another timestep");
}

void SpringReader::choose_columns() {
  std::vector<std::string> given = options_.columns;
  if (given.empty()) {
    const std::vector<Token>& words = reader_.words();
    for (std::size_t k = 2; k < words.size(); ++k) given.emplace_back(words[k].text);
  }
  const std::size_t needed = options_.dimension == 2 ? 4 : 5;
  for (const std::string& name : given) {
    const auto known = std::find(spring_columns.begin(), spring_columns.end(), name);
    if (known == spring_columns.end() && name != "-" && !options_.columns.empty())
      reader_.fail(1, fmt::format("there is no column {} to read", files::quote_token(name)), columns_cure);
    meaning_.push_back(std::size_t(known - spring_columns.begin()));
  }
  for (std::size_t k = 0; k < needed; ++k)
    if (const auto count = std::count(meaning_.begin(), meaning_.end(), k); count != 1)
      reader_.fail(1,
                   fmt::format("{} has the name '{}'", count == 0 ? "no column" : "more than one column",
                               spring_columns[k]),
                   columns_cure);
}

void SpringReader::read_spring() {
  const std::vector<Token>& words = reader_.words();
  if (words.size() != meaning_.size())
    reader_.fail(
        1, fmt::format("{} under {}", counted(words.size(), "word"), counted(meaning_.size(), "column")),
        "complete the line, or name each column in springs.columns");
  Spring spring;
  spring.line = reader_.line_number();
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (meaning_[k] == not_read) continue;
    if (meaning_[k] < 2)
      (meaning_[k] == 0 ? spring.a : spring.b) =
          reader_.positive_integer(words[k], spring_columns[meaning_[k]]);
    else if (int(meaning_[k]) - 2 < options_.dimension)
      spring.displacement[int(meaning_[k]) - 2] =
          options_.factor * reader_.number(words[k], spring_columns[meaning_[k]]);
  }
  check_pair(spring);
  springs_.push_back(spring);
}

void SpringReader::check_pair(const Spring& spring) {
  if (spring.a == spring.b)
    reader_.fail(1, fmt::format("body {} is paired with itself", spring.a), "check the columns a and b");
  const auto [place, is_new] = line_of_.try_emplace(std::minmax(spring.a, spring.b), spring.line);
  if (!is_new)
    reader_.fail(
        1,
        fmt::format("the pair of bodies {} and {} stands in line {} too", spring.a, spring.b, place->second),
        "list each pair once");
}

}  // namespace

std::vector<Spring> parse_springs(std::string_view text, const std::string& name,
                                  const SpringOptions& options) {
  TextReader reader(text, name);
  const std::vector<DumpFrame> frames = find_frames(reader);
  reader.seek(choose_frame(frames, options.timestep, reader).start);
  return SpringReader(reader, options).read();
}

std::vector<Spring> read_springs(const std::filesystem::path& path, const SpringOptions& options) {
  return parse_springs(files::read_text(path), path.string(), options);
}

}  // namespace scree::packing
