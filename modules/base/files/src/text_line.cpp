#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_line.hpp>

namespace scree::files {

namespace {

constexpr std::string_view blanks = " \t\v\f\r";

// std::from_chars rejects a plus sign, which other programs write.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

}  // namespace

void refuse_compressed(std::string_view text, std::string_view name) {
  constexpr std::string_view gzip = "\x1f\x8b";
  constexpr std::string_view zstandard = "\x28\xb5\x2f\xfd";
  const bool gzipped = text.starts_with(gzip);
  if (gzipped || text.starts_with(zstandard))
    throw Error(
        fmt::format("{}: the file is compressed; unpack it with {}", name, gzipped ? "gunzip" : "unzstd"));
}

std::string quote_token(std::string_view text) {
  constexpr std::size_t max_length = 40;
  return fmt::format("'{}{}'", escaped(text.substr(0, max_length), Escapes::bytes),
                     text.size() > max_length ? "..." : "");
}

void TextLine::set(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  line_ = line;
  ++line_number_;
}

bool TextLine::is_comment() const {
  const Token content = trimmed(0, line_.size());
  return content.text.empty() || content.text[0] == '#';
}

const std::vector<Token>& TextLine::words() {
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

// The comma behind the cell that begins there, or the end of the line. Commas within double quotes, which are doubled within them, are of the cell.
std::size_t TextLine::end_of_cell(std::size_t begin) const {
  const std::size_t first = line_.find_first_not_of(blanks, begin);
  std::size_t quote = first != line_.npos && line_[first] == '"' ? line_.find('"', first + 1) : line_.npos;
  while (quote != line_.npos && quote + 1 < line_.size() && line_[quote + 1] == '"')
    quote = line_.find('"', quote + 2);
  return std::min(line_.find(',', quote != line_.npos ? quote : begin), line_.size());
}

const std::vector<Token>& TextLine::cells() {
  tokens_.clear();
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = end_of_cell(begin);
    Token cell = trimmed(begin, end);
    if (cell.text.size() >= 2 && cell.text.front() == '"' && cell.text.back() == '"') {
      cell = {cell.text.substr(1, cell.text.size() - 2), cell.column + 1};
    }
    tokens_.push_back(cell);
    if (end == line_.size()) return tokens_;
    begin = end + 1;
  }
}

Token TextLine::trimmed(std::size_t begin, std::size_t end) const {
  std::string_view text = line_.substr(begin, end - begin);
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {text.substr(0, 0), begin + 1};
  return {text.substr(first, text.find_last_not_of(blanks) - first + 1), begin + first + 1};
}

double TextLine::any_number(const Token& token, std::string_view what) const {
  const std::string_view text = without_plus(token.text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    fail(token.column, fmt::format("{} {} is outside the range of a double", what, quote_token(token.text)),
         "check the unit and the exponent");
  }
  if (error != std::errc() || end != text.data() + text.size()) {
    fail(token.column, fmt::format("{} {} is not a number", what, quote_token(token.text)),
         "write a number such as 1.5e-3");
  }
  return value;
}

double TextLine::number(const Token& token, std::string_view what) const {
  const double value = any_number(token, what);
  if (!std::isfinite(value)) {
    fail(token.column, fmt::format("{} {} is not finite", what, quote_token(token.text)),
         "write a finite number; the run that wrote this may have failed");
  }
  return value;
}

double TextLine::positive_number(const Token& token, std::string_view what) const {
  const double value = number(token, what);
  if (!(value > 0.0)) {
    fail(token.column, fmt::format("{} {} is not positive", what, quote_token(token.text)),
         "write a number above 0");
  }
  return value;
}

std::int64_t TextLine::integer(const Token& token, std::string_view what) const {
  const std::string_view text = without_plus(token.text);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    fail(token.column, fmt::format("{} {} does not fit into 64 bits", what, quote_token(token.text)),
         "write a smaller integer");
  }
  if (error != std::errc() || end != text.data() + text.size()) {
    fail(token.column, fmt::format("{} {} is not an integer", what, quote_token(token.text)),
         "write an integer such as 12");
  }
  return value;
}

std::int64_t TextLine::positive_integer(const Token& token, std::string_view what) const {
  const std::int64_t value = integer(token, what);
  if (value <= 0) {
    fail(token.column, fmt::format("{} {} is not positive", what, quote_token(token.text)),
         "write an integer from 1 on");
  }
  return value;
}

void TextLine::fail(std::size_t column, std::string_view message, std::string_view cure) const {
  throw Error(
      fmt::format("{}:{}:{}: {}; {}", name_, std::max<std::size_t>(line_number_, 1), column, message, cure));
}

}  // namespace scree::files
