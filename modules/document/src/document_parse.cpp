#include "document_parse.hpp"

#include "document_depth.hpp"
#include "document_syntax.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <scree/error.hpp>

namespace scree::document {
namespace {

Place place_of(const toml::source_region& region) {
  return {std::max<std::uint32_t>(region.begin.line, 1), std::max<std::uint32_t>(region.begin.column, 1)};
}

// Where a text comes from: a file, whose messages carry line and column, or an override.
struct Source {
  std::string_view name;
  bool file;
};

std::string placed(const Source& source, Place place) {
  return source.file ? fmt::format("{}:{}:{}", source.name, place.line, place.column)
                     : std::string(source.name);
}

Error too_deep(const Source& source, Place place) {
  return Error(fmt::format("{}: tables or arrays more than {} deep; flatten them", placed(source, place),
                           deepest_nesting));
}

Error no_toml(const Source& source, const toml::parse_error& error) {
  return Error(
      fmt::format("{}: {}", placed(source, place_of(error.source())), syntax_complaint(error.description())));
}

template <class T>
std::string written(const T& moment) {
  std::ostringstream stream;
  stream << moment;
  return stream.str();
}

void take_scalar(const toml::node& source, Node& node) {
  source.visit([&](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (toml::is_string<Value>) {
      node.kind = NodeKind::string;
      node.text = value.get();
    } else if constexpr (toml::is_integer<Value>) {
      node.kind = NodeKind::integer;
      node.integer = value.get();
    } else if constexpr (toml::is_floating_point<Value>) {
      node.kind = NodeKind::number;
      node.number = value.get();
    } else if constexpr (toml::is_boolean<Value>) {
      node.kind = NodeKind::boolean;
      node.boolean = value.get();
    } else if constexpr (toml::is_value<Value>) {
      node.kind = NodeKind::moment;
      node.text = written(value.get());
    }
  });
}

std::unique_ptr<Node> convert(const toml::node& value, const Source& source, int depth) {
  auto node = std::make_unique<Node>();
  node->place = place_of(value.source());
  if (depth > deepest_nesting) throw too_deep(source, node->place);
  if (const toml::table* table = value.as_table()) {
    node->kind = NodeKind::table;
    node->inline_table = table->is_inline();
    for (const auto& [key, entry] : *table) {
      Node& child = node->add(convert(entry, source, depth + 1));
      child.key = key.str();
      child.key_place = place_of(key.source());
    }
    std::stable_sort(node->children.begin(), node->children.end(),
                     [](const auto& a, const auto& b) { return a->key_place < b->key_place; });
  } else if (const toml::array* array = value.as_array()) {
    node->kind = NodeKind::array;
    for (const toml::node& element : *array) node->add(convert(element, source, depth + 1));
  } else {
    take_scalar(value, *node);
  }
  return node;
}

void mark(Node& node, std::size_t number) {
  node.origin = number;
  for (const auto& child : node.children) mark(*child, number);
}

std::unique_ptr<Node> string_node(std::string_view text) {
  auto node = std::make_unique<Node>();
  node->kind = NodeKind::string;
  node->text = text;
  return node;
}

}  // namespace

std::unique_ptr<Node> parse_toml(std::string_view text, std::string_view name) {
  const Source source{name, true};
  if (const auto place = find_endless_key(text)) throw too_deep(source, *place);
  try {
    return convert(toml::parse(text), source, 0);
  } catch (const toml::parse_error& error) {
    throw no_toml(source, error);
  }
}

bool is_toml_text(std::string_view text) {
  std::string comment = "# " + std::string(text);
  for (char& c : comment) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F) c = ' ';
  }
  try {
    return toml::parse(comment).empty();
  } catch (const toml::parse_error&) {
    return false;
  }
}

std::unique_ptr<Node> parse_override_value(std::string_view text, std::size_t number,
                                           std::string_view place) {
  const Source source{place, false};
  if (find_endless_key(text)) throw too_deep(source, {});
  std::unique_ptr<Node> node;
  try {
    const toml::table table = toml::parse("value = " + std::string(text));
    node = table.size() == 1 ? convert(*table.get("value"), source, 0) : string_node(text);
  } catch (const toml::parse_error& error) {
    const bool meant_as_toml = std::string_view("[{\"'").find(text.front()) != std::string_view::npos;
    if (meant_as_toml) throw no_toml(source, error);
    node = string_node(text);
  }
  mark(*node, number);
  return node;
}

}  // namespace scree::document
