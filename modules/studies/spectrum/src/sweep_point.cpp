#include "sweep_point.hpp"

namespace scree::spectrum {

void SweepPoint::transfer(const StateTransfer& state, std::size_t observed) {
  state.value("frequency", "1/s", frequency, stored::positive);
  state.value("start", "s", start);
  state.value("steps", "1", steps);
  state.value("drive", "m", drive, stored::any);
  state.value("periods", "1", periods, stored::non_negative);
  state.value("is_steady", "", is_steady);
  std::vector<double> numbers;
  if (state.restoring()) numbers.resize(4 * observed);
  for (const Column& c : columns)
    numbers.insert(numbers.end(), {c.response.real(), c.response.imag(), c.error, c.mean});
  state.sized_rows("columns", "1", numbers, 1, stored::any);
  columns.resize(numbers.size() / 4);
  for (std::size_t c = 0; c < columns.size(); ++c)
    columns[c] = {{numbers[4 * c], numbers[4 * c + 1]}, numbers[4 * c + 2], numbers[4 * c + 3]};
}

}  // namespace scree::spectrum
