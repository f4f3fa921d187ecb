#include <cmath>

#include <scree/document/message.hpp>
#include <scree/document/range.hpp>

namespace scree::document {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string with_unit(double value, const std::string& unit) {
  return number_text(value) + (unit.empty() || value == 0 ? "" : " " + unit);
}

}  // namespace

Range Range::any(std::string_view unit) { return {-infinity, infinity, true, unit}; }
Range Range::positive(std::string_view unit) { return above(0, unit); }
Range Range::non_negative(std::string_view unit) { return at_least(0, unit); }
Range Range::above(double low, std::string_view unit) { return {low, infinity, false, unit}; }
Range Range::at_least(double low, std::string_view unit) { return {low, infinity, true, unit}; }
Range Range::between(double low, double high, std::string_view unit) { return {low, high, true, unit}; }

bool Range::contains(double value) const {
  return std::isfinite(value) && value <= high_ && (low_included_ ? value >= low_ : value > low_);
}

std::string Range::fault(double value) const {
  if (value > high_) return "is above " + with_unit(high_, unit_);
  if (low_ == 0) return value == 0 ? "is zero" : "is negative";
  return (value == low_ ? "is not above " : "is below ") + with_unit(low_, unit_);
}

std::string Range::wanted() const {
  if (std::isinf(low_)) return std::isinf(high_) ? "" : "up to " + with_unit(high_, unit_);
  if (std::isinf(high_))
    return low_included_ ? "of " + with_unit(low_, unit_) + " or more" : "above " + with_unit(low_, unit_);
  return "from " + number_text(low_) + " to " + with_unit(high_, unit_);
}

}  // namespace scree::document
