#pragma once

#include "body_field.hpp"

#include <string>
#include <vector>

namespace scree::packing {

// A column of a table of another code.
struct TableColumn {
  enum class Kind {
    value,      // of the field
    unread,     // nothing that a body has
    from_0,     // number of a material, the first being 0
    type,       // the same, the first being 1
    id_from_0,  // an id, the first being 0
  };
  std::string name;  // in the file
  BodyField field = BodyField::x;
  Kind kind = Kind::value;
};

// The columns that words name, with their units in brackets; those with other names are unread. Fails for a
// unit that is not SI.
std::vector<TableColumn> columns_of_names(const std::vector<Token>& names, const TextReader& reader);
// Whether these are enough for a table: x, y and a size.
bool are_complete(const std::vector<TableColumn>& columns);
// The columns of 'x_y_z_r_matId', as in the first line of a table of YADE.
std::vector<TableColumn> columns_of_yade(const Token& format, const TextReader& reader);
// "x y z radius (without force, torque)"
std::string text_of(const std::vector<TableColumn>& columns);

}  // namespace scree::packing
