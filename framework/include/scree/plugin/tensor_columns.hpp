#pragma once

#include <cstdint>
#include <string>

#include <scree/plugin/probe.hpp>
#include <scree/plugin/symmetric_tensor.hpp>

namespace scree {

// The columns of a tensor in a row of a probe: its components, mean p, deviator q, principal values, the
// largest first, and the direction of the first. In three dimensions 6 + 2 + 3 + 3, in two 3 + 2 + 2 + 2.
struct TensorColumns {
  int dimension = 3;
  const char* unit = "";

  std::uint32_t count() const { return dimension == 2 ? 9 : 14; }

  ColumnName name(std::uint32_t c) const {
    static constexpr const char* spatial[] = {"xx",    "yy",      "zz",      "xy",     "xz",
                                              "yz",    "p",       "q",       "major",  "middle",
                                              "minor", "major_x", "major_y", "major_z"};
    static constexpr const char* planar[] = {"xx",    "yy",    "xy",      "p",      "q",
                                             "major", "minor", "major_x", "major_y"};
    const std::uint32_t directions = count() - std::uint32_t(dimension);
    const std::string text = dimension == 2 ? planar[c] : spatial[c];
    return {text, c < directions ? unit : "", meaning(text)};
  }

  // Writes the values behind `row` and returns the end.
  double* write(const SymmetricTensor& t, double* row) const {
    const PrincipalValues principal = principal_values(t, dimension);
    const auto put = [&row](double value) { *row++ = value; };
    put(t.xx);
    put(t.yy);
    if (dimension == 3) put(t.zz);
    put(t.xy);
    if (dimension == 3) put(t.xz);
    if (dimension == 3) put(t.yz);
    put(t.mean(dimension));
    put(deviator(principal, dimension));
    for (int k = 0; k < dimension; ++k) put(principal.values[std::size_t(k)]);
    for (int k = 0; k < dimension; ++k) put(principal.major[k]);
    return row;
  }

 private:
  static const char* meaning(const std::string& name) {
    if (name == "p") return "mean of the normal components";
    if (name == "q") return "deviator: √(3 J₂), in 2D half of the difference of the principal values";
    if (name == "major") return "largest principal value";
    if (name == "middle") return "principal value";
    if (name == "minor") return "smallest principal value";
    return name.starts_with("major_") ? "direction of the largest principal value"
                                      : "component, symmetric part";
  }
};

}  // namespace scree
