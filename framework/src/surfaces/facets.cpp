#include "surfaces/facets.hpp"

#include "surfaces/nearest_point.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scree {

namespace {

using std::numbers::pi;

constexpr std::uint32_t around = 72, along_ball = 24;  // cells of a whole turn, and from pole to pole
constexpr std::uint32_t along_flat = 24, most = 288;   // of the longer side; of any side

// Of a share of a whole turn, which ends where it began to the last bit.
double angle_of(double share) { return share < 1 ? 2 * pi * share : 0; }

// Cells of a length (m) that are about as long as they are wide.
std::uint32_t cells_of(double length, double width) {
  const double cells = std::ceil(length / width - 1e-9);
  return cells >= 1 ? std::uint32_t(std::min<double>(cells, most)) : 1;
}

// The cell of a share from 0 to 1.
std::uint32_t cell_at(double share, std::uint32_t cells) {
  return std::uint32_t(std::clamp(std::floor(share * cells), 0.0, double(cells - 1)));
}

double length_of_line(const scree_surface& s) {
  return std::hypot(s.size[2] - s.size[0], s.size[3] - s.size[1]);
}

double polar_of(const scree_surface& s, double limit) {
  return std::acos(std::clamp(-limit / s.size[0], -1.0, 1.0));
}

}  // namespace

FacetGrid::FacetGrid(const scree_surface& s, int dimension) : surface_(s), dimension_(dimension) {
  if (s.shape == SCREE_BALL) {
    first_polar_ = polar_of(s, s.size[1]), last_polar_ = polar_of(s, s.size[2]);
    columns_ = dimension == 2 ? around / 2 : around;
    rows_ = dimension == 2 ? 2 : along_ball;
  } else if (s.shape == SCREE_REVOLVED) {
    columns_ = around;
    rows_ = cells_of(length_of_line(s), 2 * pi * std::max(s.size[0], s.size[2]) / around);
  } else if (s.shape == SCREE_FLAT) {
    const double width = std::max(s.size[0], dimension == 2 ? 0 : s.size[1]) / along_flat;
    columns_ = cells_of(s.size[0], width);
    rows_ = dimension == 2 ? 1 : cells_of(s.size[1], width);
  }
}

Vec3 FacetGrid::corner(std::uint32_t column, std::uint32_t row) const {
  const double* const size = surface_.size;
  const double u = double(column) / columns_, v = double(row) / rows_;
  if (surface_.shape == SCREE_FLAT)
    return {{(2 * u - 1) * size[0], dimension_ == 2 ? 0 : (2 * v - 1) * size[1], 0}};
  if (is_half_circle()) {
    const double polar = first_polar_ + u * (last_polar_ - first_polar_), side = row == 0 ? -1 : 1;
    return size[0] * Vec3{{side * std::sin(polar), -std::cos(polar), 0}};
  }
  const double turn = angle_of(u);
  if (surface_.shape == SCREE_REVOLVED) {
    const double radius = size[0] + v * (size[2] - size[0]);
    return {{radius * std::cos(turn), radius * std::sin(turn), size[1] + v * (size[3] - size[1])}};
  }
  const double polar = first_polar_ + v * (last_polar_ - first_polar_);
  return size[0] *
         Vec3{{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), -std::cos(polar)}};
}

std::uint32_t FacetGrid::column_at(const Vec3& x) const {
  if (surface_.shape == SCREE_FLAT) return cell_at(0.5 + 0.5 * x[0] / surface_.size[0], columns_);
  if (is_half_circle())
    return cell_at((std::atan2(std::abs(x[0]), -x[1]) - first_polar_) / (last_polar_ - first_polar_),
                   columns_);
  const double turn = std::atan2(x[1], x[0]) / (2 * pi);
  return cell_at(turn < 0 ? turn + 1 : turn, columns_);
}

std::uint32_t FacetGrid::row_at(const Vec3& x) const {
  const double* const size = surface_.size;
  if (surface_.shape == SCREE_FLAT) return dimension_ == 2 ? 0 : cell_at(0.5 + 0.5 * x[1] / size[1], rows_);
  if (is_half_circle()) return x[0] < 0 ? 0 : 1;
  const double from_axis = std::hypot(x[0], x[1]);
  if (surface_.shape == SCREE_BALL)
    return cell_at((std::atan2(from_axis, -x[2]) - first_polar_) / (last_polar_ - first_polar_), rows_);
  const double along = (from_axis - size[0]) * (size[2] - size[0]) + (x[2] - size[1]) * (size[3] - size[1]);
  const double length = length_of_line(surface_);
  return cell_at(along / (length * length), rows_);
}

std::size_t FacetGrid::at(const Vec3& x) const { return std::size_t(row_at(x)) * columns_ + column_at(x); }

Facets::Facets(const scree_surface& surface, const TriangleMesh* mesh, int dimension)
    : mesh_(mesh),
      grid_(surface, dimension),
      size_(mesh ? mesh->triangles().size() : std::size_t(grid_.columns()) * grid_.rows()) {}

bool is_infinite(const scree_surface& s, int dimension) {
  return s.shape != SCREE_MESH && std::isinf(reach_of(s, dimension));
}

}  // namespace scree
