#include "html.hpp"

#include "numbers.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include <scree/charts/text_fit.hpp>
#include <scree/counted.hpp>

namespace scree::report {

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : charts::drawable_text(text)) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '"')
      html += "&quot;";
    else
      html += c;
  }
  return html;
}

std::string escaped_lines(const std::string& text, std::size_t longest) {
  std::istringstream lines(text.substr(0, longest));
  std::string html;
  for (std::string line; std::getline(lines, line);) html += escaped(line) + '\n';
  if (text.size() > longest) html += "...\n";
  return html;
}

std::string breakable(const std::string& text) {
  std::string html;
  for (const char c : escaped(text)) {
    html += c;
    if (c == '.' || c == '_') html += "<wbr>";
  }
  return html;
}

std::string element(const char* name, const std::string& html, const char* kind) {
  const std::string attribute = *kind ? fmt::format(" class=\"{}\"", kind) : "";
  return fmt::format("<{0}{1}>{2}</{0}>", name, attribute, html);
}

std::string paragraph(const std::string& text) { return element("p", escaped(text)) + '\n'; }

std::string code(const std::string& text) { return element("code", escaped(text)); }

std::string section(const std::string& title, const std::string& html) {
  if (html.empty()) return "";
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escaped(title), html);
}

std::string folded(const std::string& title, const std::string& html) {
  if (html.empty()) return "";
  return fmt::format("<details>\n<summary>{}</summary>\n{}</details>\n", escaped(title), html);
}

void Table::add(std::vector<std::string> html) {
  if (rows_.size() == longest)
    ++left_out_;
  else
    rows_.push_back(std::move(html));
}

bool Table::is_shown(std::size_t column) const {
  return std::any_of(rows_.begin(), rows_.end(), [&](const std::vector<std::string>& row) {
    return column < row.size() && !row[column].empty() && row[column] != no_number;
  });
}

std::string Table::html(const std::string& where) const {
  if (rows_.empty()) return "";
  std::string head, body;
  for (std::size_t k = 0; k < headings_.size(); ++k)
    if (is_shown(k))
      head += fmt::format("<th scope=\"col\"{}>{}</th>", headings_[k].number ? " class=\"number\"" : "",
                          breakable(headings_[k].text));
  for (const std::vector<std::string>& row : rows_) {
    body += "<tr>";
    for (std::size_t k = 0; k < std::min(row.size(), headings_.size()); ++k)
      if (is_shown(k))
        body += fmt::format("<td{}>{}</td>", headings_[k].number ? " class=\"number\"" : "", row[k]);
    body += "</tr>\n";
  }
  std::string text = fmt::format(
      "<div class=\"wide\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n", head,
      body);
  if (left_out_)
    text += paragraph(fmt::format("{} more{}.", counted(left_out_, "row"),
                                  where.empty() ? "" : fmt::format(" in {}", where)));
  return text;
}

void Facts::add(const std::string& name, const std::string& html) {
  if (!html.empty()) rows_ += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(name), html);
}

std::string Facts::html() const { return rows_.empty() ? "" : fmt::format("<dl>\n{}</dl>\n", rows_); }

std::string base64(std::string_view bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t k) {
    return k < bytes.size() ? unsigned(static_cast<unsigned char>(bytes[k])) : 0u;
  };
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const unsigned group = byte(k) << 16 | byte(k + 1) << 8 | byte(k + 2);
    const std::size_t used = std::min<std::size_t>(3, bytes.size() - k) + 1;
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += digit < used ? digits[group >> (18 - 6 * digit) & 63] : '=';
  }
  return text;
}

std::string address(const std::string& path) {
  static constexpr std::string_view plain = "-_.~/=,+";  // no colon, before which a protocol is read
  std::string text;
  for (const char c : path) {
    const bool is_word = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    text += is_word || plain.find(c) != plain.npos
                ? std::string(1, c)
                : fmt::format("%{:02X}", unsigned(static_cast<unsigned char>(c)));
  }
  return text;
}

}  // namespace scree::report
