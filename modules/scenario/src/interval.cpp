#include "interval.hpp"

#include <fmt/format.h>

namespace scree::scenario {

double read_interval(const document::Table& table, const Key& key, double step) {
  const double every = table.number(key, key.range);
  if (every < 0.999 * step)
    throw table.error(
        key, fmt::format("{} = {:g} s is shorter than the time step of {:g} s", key.name, every, step),
        "increase it, or decrease time.step");
  return every;
}

}  // namespace scree::scenario
