// Time of one core for what ranks add to the work of a body at their border: its record copied to a buffer
// and from a buffer, and a load added from a buffer. Prints ns of a record on each side and of a load.
//
// Loads are sent from where the kernel stores them, as those for other tiles are now, so that only adding
// them is counted, and this in full although the kernel adds loads of other tiles too.
//
// Build: c++ -std=c++20 -O2 copies.cpp -o copies

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace {

constexpr std::size_t bodies = 33000, ghosts = 3200, loads = 2 * ghosts;
struct Record {
  double numbers[20];
};
struct Load {
  double numbers[8];
};

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// What a step leaves in the caches: all bodies and pairs have been read and written since.
void sweep(std::vector<double>& other) {
  for (double& number : other) number += 1;
}

// Least time (ns) of an item, of 200 samples: other load only adds to it.
template <class Run>
double least(std::size_t items, std::vector<double>& other, const Run& run) {
  double best = std::numeric_limits<double>::infinity();
  for (int sample = 0; sample < 200; ++sample) {
    sweep(other);
    const double start = seconds();
    run();
    best = std::min(best, 1e9 * (seconds() - start) / double(items));
  }
  return best;
}

// Places in runs of about 8, in order, as bodies of a border have in a tile that is sorted along a curve.
std::vector<std::uint32_t> places(std::size_t number, std::mt19937& random) {
  std::vector<std::uint32_t> result;
  const std::size_t runs = number / 8, distance = bodies / runs;
  for (std::size_t k = 0; k < runs; ++k) {
    const std::size_t at = k * distance + random() % (distance - 8);
    for (std::size_t i = 0; i < 8; ++i) result.push_back(std::uint32_t(at + i));
  }
  return result;
}

}  // namespace

int main() {
  std::mt19937 random(1);
  std::vector<Record> records(bodies + ghosts), buffer(ghosts);
  std::vector<Load> sums(bodies), received(loads);
  std::vector<double> other(2'000'000);  // 16 MB
  const std::vector<std::uint32_t> border = places(ghosts, random);
  const double sent = least(ghosts, other, [&] {
    for (std::size_t k = 0; k < border.size(); ++k) buffer[k] = records[border[k]];
  });
  const double read = least(
      ghosts, other, [&] { std::memcpy(records.data() + bodies, buffer.data(), ghosts * sizeof(Record)); });
  const double added = least(loads, other, [&] {
    for (std::size_t k = 0; k < loads; ++k)
      for (int i = 0; i < 8; ++i) sums[border[k / 2]].numbers[i] += received[k].numbers[i];
  });
  std::printf("record sent %.1f, received %.1f, load added %.1f ns (%g)\n", sent, read, added,
              sums[0].numbers[0] + buffer[0].numbers[0]);
}
