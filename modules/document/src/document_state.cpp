#include "document_state.hpp"

#include "document_message.hpp"

#include <fmt/format.h>

#include <scree/files/text.hpp>

namespace scree::document {
namespace {

constexpr std::size_t longest_override = 160;

std::string in_file(const std::string& name, Place place) {
  return fmt::format("{}:{}:{}", name, place.line, place.column);
}

}  // namespace

std::string DocumentState::override_text(std::size_t number) const {
  return "--set " + files::one_line(overrides[number], longest_override);
}

std::string DocumentState::place_text(const Node& node) const {
  return node.origin == Node::in_file ? in_file(name, node.place) : override_text(node.origin);
}

std::string DocumentState::key_place_text(const Node& node) const {
  return node.origin == Node::in_file ? in_file(name, node.key_place) : override_text(node.origin);
}

Error DocumentState::error(const Node& node, std::string_view what, std::string_view cure) const {
  return Error(fmt::format("{}: {}; {}", place_text(node), what, cure));
}

}  // namespace scree::document
