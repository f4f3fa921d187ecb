#include "text_reader.hpp"

namespace scree::packing {

TextReader::TextReader(std::string_view text, std::string name) : TextLine(std::move(name)), text_(text) {
  files::refuse_compressed(text_, this->name());
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    while (next() && next_start_ <= nul) {
    }
    fail(nul - line_start_ + 1, "not a text file: it contains a zero byte", "give an uncompressed text file");
  }
  if (text.starts_with(files::byte_order_mark)) next_start_ = files::byte_order_mark.size();
}

bool TextReader::next() {
  if (next_start_ >= text_.size()) return false;
  line_start_ = next_start_;
  const std::size_t end = text_.find('\n', line_start_);
  next_start_ = end == std::string_view::npos ? text_.size() : end + 1;
  set(text_.substr(line_start_, end == std::string_view::npos ? end : end - line_start_));
  return true;
}

bool TextReader::next_words() {
  while (next()) {
    if (!words().empty()) return true;
  }
  return false;
}

void TextReader::seek(Position position) {
  next_start_ = position.offset;
  set_line_number(position.line_number);
}

}  // namespace scree::packing
