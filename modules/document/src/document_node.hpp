#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace scree::document {

// Where something stands in the file, both from 1; column in characters, not bytes.
struct Place {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  friend auto operator<=>(const Place&, const Place&) = default;
};

enum class NodeKind { table, array, string, integer, number, boolean, moment };

// One value of the document, with its place and what has been asked of it.
struct Node {
  static constexpr std::size_t in_file = static_cast<std::size_t>(-1);

  NodeKind kind = NodeKind::table;
  std::string key;  // in the table above; empty for elements of arrays and the root
  Place place;      // of the value
  Place key_place;
  std::size_t origin = in_file;  // or the number of the override that wrote it
  Node* parent = nullptr;
  bool inline_table = false;

  std::string text;  // of a string, or of a date or time as written
  std::int64_t integer = 0;
  double number = 0;
  bool boolean = false;
  std::vector<std::unique_ptr<Node>> children;  // entries of a table or elements of an array, in file order

  std::vector<std::string> known;  // keys asked for on this table, in order of asking
  bool accepted = false;           // nothing below is unknown

  bool is_number() const { return kind == NodeKind::integer || kind == NodeKind::number; }
  bool is_array_of_tables() const;
  Node* find(std::string_view name) const;
  Node& add(std::unique_ptr<Node> child);
  void know(std::string_view name);

  // As an override would write it: "contact[1].friction".
  std::string path() const;
  // As the file writes it: "[time]", "[[contact]]", "the file".
  std::string label() const;
  // Kind and value for messages: a string ("2e-5").
  std::string description() const;
};

// The path from the top to an entry of that name below a node.
std::string path_below(const Node& table, std::string_view key);

}  // namespace scree::document
