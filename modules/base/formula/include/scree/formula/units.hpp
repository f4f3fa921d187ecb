#pragma once

#include <string>
#include <vector>

#include <scree/formula/formula.hpp>

namespace scree::formula {

// The unit of a formula, "" if dimensionless, from the units of its names: N/m^2 + Pa is of N/m^2, Pa/Pa of
// none. Numbers have the unit of what they are added to. Throws FormulaError for a sum of different units,
// and for a power that has no unit.
std::string unit_of(const Formula& formula, const std::vector<std::string>& units);

}  // namespace scree::formula
