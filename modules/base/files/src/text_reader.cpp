#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/files/text_reader.hpp>

namespace scree::files {

namespace {

constexpr std::string_view blanks = " \t\v\f\r";

// A longer line of a file is not read: the file is no text.
constexpr std::size_t longest_line = 1u << 20;

// std::from_chars rejects a plus sign, which other programs write.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

// begin: of the text.
void refuse_compressed(std::string_view begin, const std::string& name) {
  constexpr std::string_view gzip = "\x1f\x8b";
  constexpr std::string_view zstandard = "\x28\xb5\x2f\xfd";
  const bool gzipped = begin.starts_with(gzip);
  if (gzipped || begin.starts_with(zstandard))
    throw Error(name, "the file is compressed", gzipped ? "unpack it with gunzip" : "unpack it with unzstd");
}

[[noreturn]] void refuse_binary(const TextReader& reader, std::size_t column) {
  reader.fail(column, "not a text file: it contains a zero byte", "give an uncompressed text file");
}

}  // namespace

std::string quote_token(std::string_view text) {
  constexpr std::size_t max_length = 40;
  return fmt::format("'{}{}'", escaped(text.substr(0, max_length), Escapes::bytes),
                     text.size() > max_length ? "..." : "");
}

TextReader::TextReader(std::string_view text, std::string name) : name_(std::move(name)), text_(text) {
  refuse_compressed(text_, name_);
  if (const std::size_t zero = text.find('\0'); zero != text.npos) {
    while (next() && next_start_ <= zero) {
    }
    refuse_binary(*this, zero - line_start_ + 1);
  }
  if (text.starts_with(byte_order_mark)) next_start_ = byte_order_mark.size();
}

TextReader::TextReader(const std::filesystem::path& file)
    : name_(file.string()), file_(open_text(file), std::fclose) {}

bool TextReader::next() { return file_ ? next_of_file() : next_of_text(); }

bool TextReader::next_of_text() {
  if (next_start_ >= text_.size()) return false;
  line_start_ = next_start_;
  const std::size_t end = text_.find('\n', line_start_);
  whole_ = end != text_.npos;
  next_start_ = whole_ ? end + 1 : text_.size();
  set(text_.substr(line_start_, whole_ ? end - line_start_ : end));
  return true;
}

bool TextReader::next_of_file() {
  line_of_file_.clear();
  whole_ = true;
  errno = 0;
  for (int byte; (byte = getc_unlocked(file_.get())) != '\n';) {
    if (byte == EOF) {
      if (std::ferror(file_.get()))
        throw ReadError(name_, "cannot be read to its end", "check the disk, and that it is a file", errno);
      if (line_of_file_.empty()) return false;
      whole_ = false;
      break;
    }
    line_of_file_.push_back(char(byte));
    if (line_of_file_.size() > longest_line) break;
  }
  if (line_number_ == 0) {
    refuse_compressed(line_of_file_, name_);
    if (line_of_file_.starts_with(byte_order_mark)) line_of_file_.erase(0, byte_order_mark.size());
  }
  set(line_of_file_);
  if (const std::size_t zero = line_.find('\0'); zero != line_.npos) refuse_binary(*this, zero + 1);
  if (line_of_file_.size() > longest_line)
    fail(1, fmt::format("the line is longer than {} bytes", longest_line),
         "give a table with a line per row");
  return true;
}

bool TextReader::next_words() {
  while (next())
    if (!words().empty()) return true;
  return false;
}

void TextReader::seek(Position position) {
  next_start_ = position.offset;
  line_number_ = position.line_number;
}

void TextReader::set(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  line_ = line;
  ++line_number_;
}

bool TextReader::is_comment() const {
  const Token content = trimmed(0, line_.size());
  return content.text.empty() || content.text[0] == '#';
}

const std::vector<Token>& TextReader::words() {
  tokens_.clear();
  const std::string_view content = line_.substr(0, line_.find('#'));
  std::size_t begin = content.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(content.find_first_of(blanks, begin), content.size());
    tokens_.push_back({content.substr(begin, end - begin), begin + 1});
    begin = content.find_first_not_of(blanks, end);
  }
  return tokens_;
}

// The comma after the cell that begins there, or the end of the line. Commas within double quotes belong to
// the cell; two double quotes there stand for one.
std::size_t TextReader::end_of_cell(std::size_t begin) const {
  const std::size_t first = line_.find_first_not_of(blanks, begin);
  std::size_t quote = first != line_.npos && line_[first] == '"' ? line_.find('"', first + 1) : line_.npos;
  while (quote != line_.npos && quote + 1 < line_.size() && line_[quote + 1] == '"')
    quote = line_.find('"', quote + 2);
  return std::min(line_.find(',', quote != line_.npos ? quote : begin), line_.size());
}

const std::vector<Token>& TextReader::cells() {
  tokens_.clear();
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = end_of_cell(begin);
    Token cell = trimmed(begin, end);
    if (cell.text.size() >= 2 && cell.text.front() == '"' && cell.text.back() == '"')
      cell = {cell.text.substr(1, cell.text.size() - 2), cell.column + 1};
    tokens_.push_back(cell);
    if (end == line_.size()) return tokens_;
    begin = end + 1;
  }
}

Token TextReader::trimmed(std::size_t begin, std::size_t end) const {
  std::string_view text = line_.substr(begin, end - begin);
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {text.substr(0, 0), begin + 1};
  return {text.substr(first, text.find_last_not_of(blanks) - first + 1), begin + first + 1};
}

double TextReader::any_number(const Token& token, std::string_view what) const {
  const std::string_view text = without_plus(token.text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range)
    fail(token.column, fmt::format("{} {} is outside the range of a double", what, quote_token(token.text)),
         "check the unit and the exponent");
  if (error != std::errc() || end != text.data() + text.size())
    fail(token.column, fmt::format("{} {} is not a number", what, quote_token(token.text)),
         "write a number such as 1.5e-3");
  return value;
}

double TextReader::number(const Token& token, std::string_view what) const {
  const double value = any_number(token, what);
  if (!std::isfinite(value))
    fail(token.column, fmt::format("{} {} is not finite", what, quote_token(token.text)),
         "write a finite number; the run that wrote this may have failed");
  return value;
}

double TextReader::positive_number(const Token& token, std::string_view what) const {
  const double value = number(token, what);
  if (!(value > 0.0))
    fail(token.column, fmt::format("{} {} is not positive", what, quote_token(token.text)),
         "write a number above 0");
  return value;
}

std::int64_t TextReader::integer(const Token& token, std::string_view what) const {
  const std::string_view text = without_plus(token.text);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range)
    fail(token.column, fmt::format("{} {} does not fit into 64 bits", what, quote_token(token.text)),
         "write a smaller integer");
  if (error != std::errc() || end != text.data() + text.size())
    fail(token.column, fmt::format("{} {} is not an integer", what, quote_token(token.text)),
         "write an integer such as 12");
  return value;
}

std::int64_t TextReader::positive_integer(const Token& token, std::string_view what) const {
  const std::int64_t value = integer(token, what);
  if (value <= 0)
    fail(token.column, fmt::format("{} {} is not positive", what, quote_token(token.text)),
         "write an integer from 1 on");
  return value;
}

void TextReader::fail(std::size_t column, const std::string& problem, const std::string& cure) const {
  throw Error(fmt::format("{}:{}:{}", name_, std::max<std::size_t>(line_number_, 1), column), problem, cure);
}

}  // namespace scree::files
