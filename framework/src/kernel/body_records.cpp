#include "body_records.hpp"

#include "lanes.hpp"

namespace scree::kernel {

namespace {

// Writes (columns[0][i], ..., columns[3][i]) as one record for each body; a null column reads as 0.
void interleave(const double* const (&columns)[4], Column<double>& records, std::size_t begin,
                std::size_t end) {
  if (records.empty()) return;
  const auto read = [](const double* column, std::size_t i) {
    Four v = {};
    if (column) __builtin_memcpy(&v, column + i, sizeof(v));
    return v;
  };
  std::size_t i = begin;
  for (; i + 4 <= end; i += 4) {
    Four rows[4];
    for (int k = 0; k < 4; ++k) rows[k] = read(columns[k], i);
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (int k = 0; k < 4; ++k) store_four(records.data() + 4 * (i + std::size_t(k)), rows[k]);
  }
  for (; i < end; ++i)
    for (std::size_t k = 0; k < 4; ++k) records[4 * i + k] = columns[k] ? columns[k][i] : 0.0;
}

}  // namespace

void deal_out(const double* records, std::size_t stride, double* const (&columns)[4], std::size_t begin,
              std::size_t end) {
  std::size_t i = begin;
  for (; i + 4 <= end; i += 4) {
    Four rows[4];
    for (std::size_t k = 0; k < 4; ++k) rows[k] = load_four(records + stride * (i + k));
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (int k = 0; k < 4; ++k)
      if (columns[k]) __builtin_memcpy(columns[k] + i, &rows[k], sizeof(Four));
  }
  for (; i < end; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (columns[k]) columns[k][i] = records[stride * i + k];
}

void BodyRecords::resize(const Particles& p, bool with_mid) {
  const std::size_t all = 4 * p.size(), none = 0;
  const bool flat = p.dimension() == 2;
  place.resize(all);
  motion.resize(all);
  mid_motion.resize(with_mid && !flat ? all : none);
  spin.resize(p.has_spin() ? all : none);
  mid_spin.resize(p.has_spin() && with_mid && !flat ? all : none);
}

std::size_t BodyRecords::bytes_per_body() const {
  std::size_t bytes = 0;
  for (const Column<double>* records : {&place, &motion, &mid_motion, &spin, &mid_spin})
    if (!records->empty()) bytes += 4 * sizeof(double);
  return bytes;
}

void BodyRecords::pack(const Particles& p, std::size_t begin, std::size_t end) {
  const double* radius = p.radius.data();
  const auto column = [](const Column<double>& c) { return c.empty() ? nullptr : c.data(); };
  if (p.dimension() == 2) {
    interleave({column(p.position[0]), column(p.position[1]), nullptr, radius}, place, begin, end);
    interleave(
        {column(p.velocity[0]), column(p.velocity[1]), column(p.mid_velocity[0]), column(p.mid_velocity[1])},
        motion, begin, end);
    interleave({column(p.spin[2]), column(p.mid_spin[2]), nullptr, nullptr}, spin, begin, end);
    return;
  }
  const auto vectors = [&](const Column<double>(&v)[3], const double* fourth, Column<double>& records) {
    interleave({column(v[0]), column(v[1]), column(v[2]), fourth}, records, begin, end);
  };
  vectors(p.position, radius, place);
  vectors(p.velocity, nullptr, motion);
  vectors(p.mid_velocity, nullptr, mid_motion);
  vectors(p.spin, nullptr, spin);
  vectors(p.mid_spin, nullptr, mid_spin);
}

}  // namespace scree::kernel
