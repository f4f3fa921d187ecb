#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <scree/state.hpp>

namespace scree::test {

// Three bodies in 3D, and an array of every type, shape and content that is easily lost.
inline State sample_state() {
  State state;
  state.put("bodies/id", {std::vector<std::int64_t>{7, -1, 1'000'000'000'000'000}, {3}, ""});
  state.put("bodies/material", {std::vector<std::uint32_t>{0, 1, 0}, {3}, ""});
  state.put("bodies/mass", {std::vector<double>{1e-3, 2e-3, 3e-3}, {3}, "kg"});
  state.put("bodies/position", {std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, -0.0}, {3, 3}, "m"});
  state.put("bodies/velocity", {std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1e-310}, {3, 3}, "m/s"});
  state.put("bodies/image", {std::vector<std::int32_t>{0, 0, 0, -1, 0, 0, 2, 0, 0}, {3, 3}, ""});
  state.put("clock/time", {std::vector<double>{0.1}, {}, "s"});
  state.put("clock/steps", {std::vector<std::uint64_t>{18'446'744'073'709'551'615u}, {}, ""});
  state.put("scene/dimension", {std::vector<std::int32_t>{3}, {}, ""});
  state.put("scene/materials", {std::vector<std::string>{"glass", "Größe 石 \U0001FAA8", ""}, {3}, ""});
  state.put("walls/domain_lower", {std::vector<double>{-1, 0, 0}, {3}, "m"});
  state.put("walls/domain_upper", {std::vector<double>{9, 0, 0}, {3}, "m"});
  return state;
}

// Numbers without equal: not a number with a payload, infinities, the ends of ranges.
inline State odd_state() {
  State state = sample_state();
  const double nan = __builtin_bit_cast(double, std::uint64_t(0x7ff4'dead'beef'0123));
  std::string long_text(100'000, 'x');
  long_text[5] = '\n', long_text[6] = '\x1b';
  using Limits = std::numeric_limits<double>;
  state.put(
      "odd/doubles",
      {std::vector<double>{Limits::infinity(), -Limits::infinity(), Limits::denorm_min()}, {1, 3}, "J"});
  state.put("odd/payload", {std::vector<double>{nan}, {1}, "1"});
  state.put("odd/floats", {std::vector<float>{1.5f, -0.0f, 3e-45f, 3e38f}, {2, 1, 2}, "N"});
  state.put("odd/bytes", {std::vector<std::uint8_t>{0, 1, 128, 255}, {4}, ""});
  state.put("odd/none", {std::vector<double>{}, {0, 3}, "m"});
  state.put("odd/no_text", {std::vector<std::string>{}, {0}, ""});
  state.put("odd/no_label", {std::vector<std::uint64_t>{1}, {}, "1"});
  state.put("odd/text", {std::vector(1, long_text), {}, ""});
  state.put("odd/zeros",
            {std::vector<std::string>{std::string("a\0b", 3), std::string("c\0", 2), ""}, {3, 1}, ""});
  state.put("odd/deeper/still/deeper",
            {std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min()}, {1, 1}, ""});
  // Of bodies, but not one row for each, or with names that have another meaning in the file.
  state.put("bodies/total", {std::vector<double>{1, 2}, {2}, "N"});
  state.put("bodies/box", {std::vector<double>{1, 2, 3}, {3}, "m"});
  state.put("bodies/species", {std::vector<double>{1, 2, 3}, {3}, "m"});
  state.put("bodies/a/value", {std::vector<double>{1, 2, 3}, {3}, "m"});
  return state;
}

}  // namespace scree::test
