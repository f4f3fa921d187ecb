#pragma once

#include "document_node.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <scree/error.hpp>

namespace scree::document {

// What all handles to one document share.
struct DocumentState {
  std::string name;
  std::vector<std::string> overrides;
  std::unique_ptr<Node> root;
  std::string outdone;                        // "<override> is undone by <override>" of the first, if any
  std::vector<std::unique_ptr<Node>> absent;  // tables that are not there but read as empty ones

  // "--set key=value" as it stands in messages.
  std::string override_text(std::size_t number) const;
  std::string place_text(const Node& node) const;
  std::string key_place_text(const Node& node) const;
  Error error(const Node& node, std::string_view what, std::string_view cure) const;
};

}  // namespace scree::document
