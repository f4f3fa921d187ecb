#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scree {

// One array of a state.
struct StateArray {
  // Row by row, the last index of the shape runs fastest.
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int64_t>, std::vector<std::uint64_t>,
               std::vector<std::int32_t>, std::vector<std::uint32_t>, std::vector<std::uint8_t>,
               std::vector<std::string>>
      values;
  std::vector<std::size_t> shape;  // its product is the number of values; empty for a single value
  std::string unit;                // SI, "kg m^2/s"; "1" for pure numbers, "" for text and indices

  std::size_t size() const;
  // Whether all bits are the same.
  friend bool operator==(const StateArray& a, const StateArray& b);
};

// The state of a simulation or of a run: arrays by path, "bodies/position". The parts of a path are separated
// by '/' and consist of lower-case letters, digits and '_'. Written and read by StateTransfer.
class State {
 public:
  bool has(std::string_view path) const { return arrays_.find(path) != arrays_.end(); }
  // Throws Error if there is no such array.
  const StateArray& at(std::string_view path) const;
  // Adds an array or replaces it.
  void put(const std::string& path, StateArray array) { arrays_[path] = std::move(array); }
  const std::map<std::string, StateArray, std::less<>>& arrays() const { return arrays_; }
  // Takes the arrays of another state whose paths are not here.
  void merge(State&& other) { arrays_.merge(other.arrays_); }
  friend bool operator==(const State&, const State&) = default;

 private:
  std::map<std::string, StateArray, std::less<>> arrays_;
};

}  // namespace scree
