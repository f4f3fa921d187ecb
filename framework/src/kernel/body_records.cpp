#include "body_records.hpp"

#include "../instruction_levels.hpp"
#include "lanes.hpp"

namespace scree::kernel {

namespace {

// Writes the columns, four to each part, to the records of the bodies [begin, end), whole records one after
// the other; a null column reads as 0.
SCREE_EVERY_LEVEL void interleave(const double* const* columns, std::size_t width, double* records,
                                  std::size_t begin, std::size_t end) {
  const auto read = [](const double* column, std::size_t i) {
    Four v = {};
    if (column) __builtin_memcpy(&v, column + i, sizeof(v));
    return v;
  };
  std::size_t i = begin;
  for (; i + 4 <= end; i += 4)
    for (std::size_t part = 0; part < width; part += 4) {
      Four rows[4];
      for (std::size_t k = 0; k < 4; ++k) rows[k] = read(columns[part + k], i);
      transpose(rows[0], rows[1], rows[2], rows[3]);
      for (std::size_t k = 0; k < 4; ++k) store_four(records + width * (i + k) + part, rows[k]);
    }
  for (; i < end; ++i)
    for (std::size_t k = 0; k < width; ++k) records[width * i + k] = columns[k] ? columns[k][i] : 0.0;
}

}  // namespace

SCREE_EVERY_LEVEL void deal_out(const double* records, std::size_t stride, double* const (&columns)[4],
                                BodyRange bodies) {
  std::size_t i = bodies.begin;
  for (; i + 4 <= bodies.end; i += 4) {
    Four rows[4];
    for (std::size_t k = 0; k < 4; ++k) rows[k] = load_four(records + stride * (i + k));
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (int k = 0; k < 4; ++k)
      if (columns[k]) __builtin_memcpy(columns[k] + i, &rows[k], sizeof(Four));
  }
  for (; i < bodies.end; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (columns[k]) columns[k][i] = records[stride * i + k];
}

void BodyRecords::resize(const Particles& p) {
  if (p.dimension() == 2)
    width_ = p.has_spin() ? RecordLayout<2, true>::width : RecordLayout<2, false>::width;
  else
    width_ = p.has_spin() ? RecordLayout<3, true>::width : RecordLayout<3, false>::width;
  records_.resize(width_ * p.size());
}

void BodyRecords::pack(const Particles& p, BodyRange bodies) {
  using Flat = RecordLayout<2, true>;
  using Layout = RecordLayout<3, true>;
  const double* columns[Layout::width] = {};
  const auto set = [&](std::size_t place, const Column<double>& column) {
    if (!column.empty() && place < width_) columns[place] = column.data();
  };
  set(Layout::place + 3, p.radius);
  for (std::size_t k = 0; k < 3; ++k) set(Layout::place + k, p.position[k]);
  for (std::size_t k = 0; k < 3; ++k) set(Layout::motion + k, p.velocity[k]);
  if (p.dimension() == 2) {
    for (std::size_t k = 0; k < 2; ++k) set(Flat::motion + 2 + k, p.mid_velocity[k]);
    set(Flat::spin, p.spin[2]);
    set(Flat::spin + 1, p.mid_spin[2]);
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      set(Layout::spin + k, p.spin[k]);
      set(Layout::mid_motion + k, p.mid_velocity[k]);
      set(Layout::mid_spin + k, p.mid_spin[k]);
    }
  }
  interleave(columns, width_, records_.data(), bodies.begin, bodies.end);
}

}  // namespace scree::kernel
