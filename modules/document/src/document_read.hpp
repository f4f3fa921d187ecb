#pragma once

#include "document_state.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <scree/document/range.hpp>

namespace scree::document {

// One value each; throw Error at the value on a wrong type, length or range.
double read_number(const DocumentState& state, const Node& node, const Range& range);
std::int64_t read_integer(const DocumentState& state, const Node& node, const Range& range);
bool read_boolean(const DocumentState& state, const Node& node);
std::string read_string(const DocumentState& state, const Node& node);
std::string read_choice(const DocumentState& state, const Node& node,
                        const std::vector<std::string>& allowed);
std::vector<double> read_numbers(const DocumentState& state, const Node& node,
                                 std::optional<std::size_t> count, const Range& range);
std::vector<std::vector<double>> read_rows(const DocumentState& state, const Node& node, std::size_t columns,
                                           const Range& range);
// Throws unless the node is an array, of that many elements where a count is given; what they are is for the
// message.
void check_array(const DocumentState& state, const Node& node, std::optional<std::size_t> count,
                 std::string_view what);
std::vector<std::string> read_strings(const DocumentState& state, const Node& node);
std::vector<std::int64_t> read_integers(const DocumentState& state, const Node& node, const Range& range);

}  // namespace scree::document
