#include "box_row.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <scree/files/csv_line.hpp>
#include <scree/plugin/walls.hpp>

namespace scree::quasi_static {

namespace {

constexpr const char* names[] = {"x", "y", "z"};

}  // namespace

BoxRow::BoxRow(const std::vector<double>& at_start, SurfaceColumns surfaces)
    : dimension_(int(at_start.size())), surfaces_(std::move(surfaces)) {
  for (int k = 0; k < dimension_; ++k)
    if (at_start[std::size_t(k)] > 0) axes_.push_back({k, at_start[std::size_t(k)]});
}

std::vector<double> BoxRow::lengths(int dimension, const Sample& sample) {
  std::vector<double> all;
  for (int k = 0; k < dimension; ++k) all.push_back(length(sample, k));
  return all;
}

double BoxRow::length(const Sample& sample, int axis) {
  const auto end = [&](int sign) { return wall_height(sample.planes, axis, sign, sample.absent.data()); };
  const double between = end(-1) - end(1);
  return std::isnan(between) ? 0 : between;
}

std::string BoxRow::head() const {
  std::vector<std::string> cells = {"time [s]"};
  for (const Axis& a : axes_) cells.push_back(fmt::format("length_{} [m]", names[a.axis]));
  if (int(axes_.size()) == dimension_)
    for (const Axis& a : axes_)
      cells.push_back(fmt::format("stress_{}{} [Pa]", names[a.axis], names[a.axis]));
  for (const Axis& a : axes_) cells.push_back(fmt::format("strain_{}{}", names[a.axis], names[a.axis]));
  for (std::string& name : surfaces_.names()) cells.push_back(std::move(name));
  cells.insert(cells.end(), {"contacts", "sliding", "dynamic"});
  return files::csv_line(cells);
}

std::string BoxRow::line(const Sample& sample) const {
  std::vector<std::string> cells = {files::csv_number(sample.time)};
  for (const Axis& a : axes_) cells.push_back(files::csv_number(length(sample, a.axis)));
  if (int(axes_.size()) == dimension_)
    for (const Axis& a : axes_) cells.push_back(files::csv_number(stress(sample, a.axis)));
  for (const Axis& a : axes_) cells.push_back(files::csv_number(strain(sample, a)));
  for (const double number : surfaces_.numbers(sample)) cells.push_back(files::csv_number(number));
  cells.push_back(fmt::format("{}", sample.contacts));
  cells.push_back(fmt::format("{}", sample.sliding));
  cells.push_back(sample.dynamic ? "1" : "0");
  return files::csv_line(cells);
}

double BoxRow::strain(const Sample& sample, const Axis& along) const {
  return 1 - length(sample, along.axis) / along.length_at_start;
}

double BoxRow::stress(const Sample& sample, int axis) const {
  double area = 1;
  for (const Axis& a : axes_)
    if (a.axis != axis) area *= length(sample, a.axis);
  return pressing_force(sample.planes, sample.loads.data(), axis, sample.absent.data()) / area;
}

bool BoxRow::has_deviatoric_strain() const {
  return axes_.size() >= 2 && axes_[0].axis == 0 && axes_[1].axis == 1;
}

std::string BoxRow::charted_surface() const {
  return has_deviatoric_strain() || surfaces_.empty() ? "" : surfaces_.first_name();
}

BoxRow::Charted BoxRow::charted(const Sample& sample) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (has_deviatoric_strain()) return {strain(sample, axes_[0]) - strain(sample, axes_[1]), none};
  if (surfaces_.empty()) return {none, none};
  const std::vector<double> numbers = surfaces_.numbers(sample);
  return {numbers[0], numbers[1]};
}

}  // namespace scree::quasi_static
