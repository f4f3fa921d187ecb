#include <algorithm>
#include <cctype>
#include <charconv>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/formula/formula.hpp>

namespace scree::formula {

namespace {

// Deeper parentheses would use up the stack of the processor.
constexpr int deepest = 100;
constexpr const char* name_cure = "give the name of a probe, a dot and one of its columns";

enum Strength : int { weak = 1, stronger = 2, strongest = 3 };
struct Sign {
  char sign;
  int strength;
};
// In the order of functions_of_two().
constexpr Sign signs[] = {{'+', weak}, {'-', weak}, {'*', stronger}, {'/', stronger}, {'^', strongest}};

bool begins_number(unsigned char c) { return std::isdigit(c) || c == '.'; }
bool begins_word(unsigned char c) { return std::isalpha(c) || c == '_' || c >= 0x80; }

template <class Functions>
std::optional<std::size_t> index_in(const Functions& functions, std::string_view word) {
  const auto is_word = [&](const auto& function) { return word == function.name; };
  const auto found = std::find_if(functions.begin(), functions.end(), is_word);
  return found == functions.end() ? std::nullopt : std::optional(std::size_t(found - functions.begin()));
}

std::vector<std::string> words_of_functions() {
  std::vector<std::string> words;
  for (const FunctionOfOne& function : functions_of_one()) words.push_back(function.name);
  for (const FunctionOfTwo& function : functions_of_two()) words.push_back(function.name);
  std::erase_if(words, [](const std::string& word) { return !begins_word(word[0]); });
  return words;
}

// Reads from left to right; each function reads what its name says and appends instructions.
class FormulaReader {
 public:
  explicit FormulaReader(std::string_view text) : text_(text) {}

  Formula read() {
    if (next() == 0)
      throw error("the formula is empty", "give an expression such as \"box.stress_xx / box.stress_zz\"");
    read_expression(weak);
    if (next() == ')') throw error("no '(' belongs to this ')'", "remove it, or add '(' before");
    if (next() != 0) refuse_rest();
    return std::move(formula_);
  }

 private:
  // Signs of at least this strength.
  void read_expression(int weakest) {
    if (++depth_ > deepest)
      throw error(fmt::format("the formula is nested more than {} levels deep", deepest),
                  "divide it into several quantities");
    read_operand();
    while (const Sign* sign = sign_here()) {
      if (sign->strength < weakest) break;
      const std::size_t at = at_++;
      read_expression(sign->sign == '^' ? sign->strength : sign->strength + 1);
      append({Operation::of_two, 0, std::size_t(sign - signs), at});
    }
    --depth_;
  }

  void read_operand() {
    const char c = next();
    const std::size_t at = at_;
    if (c == '-') {
      ++at_;
      read_expression(strongest);
      append({Operation::of_one, 0, 0, at});
    } else if (c == '(') {
      ++at_;
      read_expression(weak);
      close(at);
    } else if (begins_number((unsigned char)c)) {
      read_number();
    } else if (c == '\'') {
      read_quoted();
    } else if (begins_word((unsigned char)c)) {
      read_word();
    } else {
      refuse_operand();
    }
  }

  void read_number() {
    double number = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, failure] = std::from_chars(begin, text_.data() + text_.size(), number);
    if (failure == std::errc::result_out_of_range)
      throw error(fmt::format("'{}' is beyond the range of a number", std::string_view(begin, end)),
                  "give a number from 1e-307 to 1e308");
    if (failure != std::errc()) throw error("'.' is no number", "write it with digits, such as 0.5");
    append({Operation::constant, number, 0, at_});
    at_ += std::size_t(end - begin);
  }

  void read_quoted() {
    const std::size_t begin = at_ + 1, end = text_.find('\'', begin);
    if (end == text_.npos) throw error("the quote is not closed", "add ' behind the name");
    read_name(text_.substr(begin, end - begin), at_);
    at_ = end + 1;
  }

  void read_word() {
    const std::size_t at = at_;
    while (at_ < text_.size() &&
           (begins_word((unsigned char)text_[at_]) || begins_number((unsigned char)text_[at_])))
      ++at_;
    const std::string_view word = text_.substr(at, at_ - at);
    if (next() == '(') return read_call(word, at);
    if (word == "pi") return append({Operation::constant, std::numbers::pi, 0, at});
    read_name(word, at);
  }

  void read_name(std::string_view word, std::size_t at) {
    const std::size_t dot = word.find('.');
    if (dot == word.npos && (index_in(functions_of_one(), word) || index_in(functions_of_two(), word)))
      throw FormulaError(at, fmt::format("the function '{}' has no arguments", word),
                         fmt::format("write {}(...)", word));
    const bool is_time = word == "time";
    if (!is_time && (dot == word.npos || dot == 0 || dot + 1 == word.size()))
      throw FormulaError(at, fmt::format("'{}' is not <probe>.<column>", files::one_line(word)), name_cure);
    const auto same = [&](const Name& name) { return name.text == word; };
    const auto found = std::find_if(formula_.names.begin(), formula_.names.end(), same);
    const auto index = std::size_t(found - formula_.names.begin());
    if (found == formula_.names.end()) formula_.names.push_back({std::string(word), at});
    append({Operation::name, 0, index, at});
  }

  void read_call(std::string_view word, std::size_t at) {
    const auto unary = index_in(functions_of_one(), word), binary = index_in(functions_of_two(), word);
    if (!unary && !binary)
      throw FormulaError(at, fmt::format("no function '{}'", files::one_line(word)),
                         document::name_cure(word, words_of_functions()));
    const std::size_t parenthesis = at_++, wanted = unary ? 1 : 2;
    std::size_t arguments = next() == ')' ? 0 : 1;
    if (arguments > 0) read_expression(weak);
    for (; next() == ','; ++arguments) {
      ++at_;
      read_expression(weak);
    }
    close(parenthesis);
    if (arguments != wanted)
      throw FormulaError(at, fmt::format("{} has {}", word, counted(arguments, "argument")),
                         fmt::format("give it {}", wanted));
    append({unary ? Operation::of_one : Operation::of_two, 0, unary ? *unary : *binary, at});
  }

  // parenthesis: where the one that is closed here stands
  void close(std::size_t parenthesis) {
    if (next() == 0) throw FormulaError(parenthesis, "this '(' is not closed", "add ')'");
    if (next() != ')') refuse_rest();
    ++at_;
  }

  // What follows a complete operand and is no sign.
  [[noreturn]] void refuse_rest() {
    const char c = next();
    if (begins_word((unsigned char)c) || begins_number((unsigned char)c) || c == '(' || c == '\'')
      throw error(fmt::format("no sign before '{}'", files::one_line(text_.substr(at_))),
                  "write +, -, *, / or ^ between two numbers");
    if (c == ',') throw error("a comma is outside of min() and max()", "write '.' in numbers, such as 0.5");
    refuse_character();
  }
  [[noreturn]] void refuse_operand() {
    const char c = next();
    const bool is_sign = sign_here() || c == ')' || c == ',' || c == 0;
    if (!is_sign) refuse_character();
    const bool doubled = c == '*' && at_ > 0 && text_[at_ - 1] == '*';
    throw error(c ? fmt::format("a number or column is missing before '{}'", c)
                  : std::string("a number or column is missing at the end"),
                doubled ? "write ^ for a power" : "add it, or remove the sign");
  }
  [[noreturn]] void refuse_character() {
    std::size_t end = at_ + 1;  // of the character, which may have several bytes
    while (end < text_.size() && ((unsigned char)text_[end] & 0xc0) == 0x80) ++end;
    throw error(
        fmt::format("'{}' does not belong in a formula", files::one_line(text_.substr(at_, end - at_))),
        "write numbers, +, -, *, /, ^, parentheses, functions and columns as <probe>.<column>");
  }

  // The next character behind spaces, 0 at the end.
  char next() {
    while (at_ < text_.size() && std::isspace((unsigned char)text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : 0;
  }
  const Sign* sign_here() {
    const char c = next();
    const Sign* const found =
        std::find_if(std::begin(signs), std::end(signs), [&](const Sign& sign) { return sign.sign == c; });
    return found == std::end(signs) ? nullptr : found;
  }
  void append(const Instruction& instruction) { formula_.instructions.push_back(instruction); }
  FormulaError error(const std::string& problem, const std::string& cure) const {
    return {at_, problem, cure};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  Formula formula_;
};

}  // namespace

Formula parse(std::string_view text) { return FormulaReader(text).read(); }

}  // namespace scree::formula
