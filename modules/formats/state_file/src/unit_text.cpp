#include "unit_text.hpp"

#include <vector>

namespace scree::state_file {
namespace {

// Words between single separators.
std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    words.push_back(text.substr(begin, end - begin));
    if (end == text.npos) return words;
    begin = end + 1;
  }
}

void add(std::string& list, const std::string& word, char separator) {
  if (!list.empty()) list += separator;
  list += word;
}

}  // namespace

std::string h5md_unit(std::string_view unit) {
  std::string all;
  const std::size_t slash = unit.find('/');
  for (const std::string_view factor : split(unit.substr(0, slash), ' ')) {
    if (factor == "1" && slash != unit.npos) continue;
    std::string word(factor);
    if (const std::size_t power = word.find('^'); power != word.npos) word[power] = '+';
    add(all, word, ' ');
  }
  if (slash == unit.npos) return all;
  for (const std::string_view factor : split(unit.substr(slash + 1), ' ')) {
    std::string word(factor);
    if (const std::size_t power = word.find('^'); power != word.npos)
      word[power] = '-';
    else
      word += "-1";
    add(all, word, ' ');
  }
  return all;
}

std::string state_unit(std::string_view h5md) {
  std::string above, below;
  for (const std::string_view factor : split(h5md, ' ')) {
    std::string word(factor);
    const std::size_t sign = word.find_first_of("+-");
    if (sign == word.npos || word[sign] == '+') {
      if (sign != word.npos) word[sign] = '^';
      add(above, word, ' ');
    } else {
      const bool first_power = word.substr(sign) == "-1";
      first_power ? void(word.resize(sign)) : void(word[sign] = '^');
      add(below, word, ' ');
    }
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + '/' + below;
}

}  // namespace scree::state_file
