#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace scree::document {

// The accepted numbers of a key, and their unit for messages. NaN and infinities are never accepted.
class Range {
 public:
  static Range any(std::string_view unit = "");
  static Range positive(std::string_view unit = "");      // above 0
  static Range non_negative(std::string_view unit = "");  // 0 or more
  static Range above(double low, std::string_view unit = "");
  static Range at_least(double low, std::string_view unit = "");
  static Range between(double low, double high, std::string_view unit = "");  // both ends included

  bool contains(double value) const;
  const std::string& unit() const { return unit_; }

  // What is wrong with a value outside the range: "is negative", "is above 1".
  std::string fault(double value) const;
  // The accepted values: "above 0", "from 0 to 1 m".
  std::string wanted() const;

 private:
  Range(double low, double high, bool low_included, std::string_view unit)
      : low_(low), high_(high), low_included_(low_included), unit_(unit) {}

  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
  bool low_included_ = true;
  std::string unit_;
};

}  // namespace scree::document
