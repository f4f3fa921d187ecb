#include "ambient_occlusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace scree::pictures {
namespace {

// A chord of the ball along the direction of view.
struct Chord {
  int x, y;    // (pixels) from the centre
  float half;  // (pixels) its half length
};

constexpr std::size_t chords_per_pixel = 64;
// Neighbours have other chords: a picture averages over them.
constexpr int tile = 2;

// Chords at points that fill a disc evenly, on a spiral of the golden angle, and the same on its other
// side, so that a plane of any slope is open.
std::array<Chord, chords_per_pixel> chords_of(int turn, double radius) {
  constexpr double golden_angle = 2.399963229728653;
  constexpr std::size_t half = chords_per_pixel / 2;
  std::array<Chord, chords_per_pixel> chords;
  for (std::size_t k = 0; k < half; ++k) {
    const double distance = radius * std::sqrt((double(k) + 0.5) / double(half));
    const double angle = golden_angle * double(k) + std::numbers::pi / 4 * turn;
    const int x = int(std::lround(distance * std::cos(angle))),
              y = int(std::lround(distance * std::sin(angle)));
    const double length = std::sqrt(std::max(1.0, radius * radius - double(x) * x - double(y) * y));
    chords[k] = {x, y, float(length)};
    chords[k + half] = {-x, -y, float(length)};
  }
  return chords;
}

// Length (pixels) by which bodies fill more of the chord than its far half. What stands far before the
// surface has no hollow with it.
float filled(float rise, const Chord& chord, float radius) {
  constexpr float far = 3;
  const float inside = std::clamp(rise, -chord.half, chord.half);
  return rise > radius ? inside * std::clamp((far - rise / radius) / (far - 1), 0.0f, 1.0f) : inside;
}

float open_share(const DepthField& field, int column, int row,
                 const std::array<Chord, chords_per_pixel>& chords, float radius) {
  const float here = field.depth[std::size_t(row) * std::size_t(field.width) + std::size_t(column)];
  if (!std::isfinite(here)) return 1;
  float sum = 0, volume = 0;
  for (const Chord& chord : chords) {
    const int x = std::clamp(column + chord.x, 0, field.width - 1);
    const int y = std::clamp(row + chord.y, 0, field.height - 1);
    const float there = field.depth[std::size_t(y) * std::size_t(field.width) + std::size_t(x)];
    sum += filled(there - here, chord, radius);
    volume += chord.half;
  }
  return std::clamp(1 - sum / volume, 0.0f, 1.0f);
}

}  // namespace

std::vector<float> open_shares(const DepthField& field, double radius) {
  std::array<std::array<Chord, chords_per_pixel>, tile * tile> chords;
  for (int turn = 0; turn < tile * tile; ++turn) chords[std::size_t(turn)] = chords_of(turn, radius);
  std::vector<float> shares(field.depth.size());
  for (int row = 0; row < field.height; ++row)
    for (int column = 0; column < field.width; ++column)
      shares[std::size_t(row) * std::size_t(field.width) + std::size_t(column)] = open_share(
          field, column, row, chords[std::size_t(row % tile * tile + column % tile)], float(radius));
  return shares;
}

}  // namespace scree::pictures
