#include "sweep_point.hpp"

namespace scree::sound {

void SweepPoint::transfer(const StateTransfer& state) {
  state.value("frequency", "1/s", frequency);
  state.value("start", "s", start);
  state.value("steps", "1", steps);
  state.value("drive", "m", drive);
  state.value("periods", "1", periods);
  state.value("is_steady", "", is_steady);
  std::vector<double> numbers;
  for (const Column& c : columns)
    numbers.insert(numbers.end(), {c.response.real(), c.response.imag(), c.error, c.mean});
  state.rows("columns", "1", numbers);
  columns.resize(numbers.size() / 4);
  for (std::size_t c = 0; c < columns.size(); ++c)
    columns[c] = {{numbers[4 * c], numbers[4 * c + 1]}, numbers[4 * c + 2], numbers[4 * c + 3]};
}

}  // namespace scree::sound
