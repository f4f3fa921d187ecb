#include "bodies_writer.hpp"

#include "element_type.hpp"
#include "h5md_place.hpp"
#include "text.hpp"

#include <array>

namespace scree::state_file {
namespace {

// The numbers of an array; null if there is no such array of this type with enough numbers.
template <class T>
const T* numbers(const State& state, const char* path, std::size_t at_least) {
  if (!state.has(path)) return nullptr;
  const auto* found = std::get_if<std::vector<T>>(&state.arrays().at(path).values);
  return found && found->size() >= at_least ? found->data() : nullptr;
}

void write_integers(hid_t object, const char* name, const std::vector<std::int32_t>& values, bool single) {
  const Handle space = dataspace(single ? std::vector<std::size_t>{} : std::vector{values.size()}, false);
  const Handle attribute(H5Acreate2(object, name, file_type<std::int32_t>(), space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, name);
  checked(H5Awrite(attribute, memory_type<std::int32_t>(), values.data()), name);
}

}  // namespace

void write_h5md_group(FileWriter& writer) {
  write_integers(writer.group("h5md"), "version", {1, 1}, false);
  const Handle author = writer.group("h5md/author"), creator = writer.group("h5md/creator");
  write_attribute(author, "name", "not stated");
  write_attribute(creator, "name", "scree");
  write_attribute(creator, "version", SCREE_VERSION);
  const Handle units = writer.group("h5md/modules/units");
  write_integers(units, "version", {1, 0}, false);
  write_attribute(units, "system", "SI");
}

void write_box_attributes(hid_t box, const std::vector<std::string>& boundary) {
  write_integers(box, "dimension", {std::int32_t(boundary.size())}, true);
  const PaddedText text(boundary);
  const Handle type = text_type(text.width), space = dataspace({boundary.size()}, false);
  const Handle attribute(H5Acreate2(box, "boundary", type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "boundary");
  checked(H5Awrite(attribute, type, text.bytes.data()), "boundary");
}

BodiesWriter::BodiesWriter(FileWriter& writer, const State& state) : writer_(writer), state_(state) {
  if (!numbers<double>(state, "bodies/position", 0)) return;
  const auto& shape = state.arrays().at("bodies/position").shape;
  if (shape.size() != 2 || shape[1] < 1 || shape[1] > 3) return;
  bodies_ = shape[0], dimension_ = shape[1];
  write_box();
}

bool BodiesWriter::write(const std::string& path, const StateArray& array) {
  const auto place = h5md_place(path);
  const bool fits = dimension_ > 0 && !array.shape.empty() && array.shape[0] == bodies_;
  if (!place || !fits) return false;
  writer_.array(place->dataset(), array, place->as_frame);
  if (place->as_frame) write_time(place->element);
  return true;
}

void BodiesWriter::write_box() {
  const std::string name = "particles/bodies/box";
  const Handle box = writer_.group(name);
  const auto* lower = numbers<double>(state_, "walls/domain_lower", dimension_);
  const auto* upper = numbers<double>(state_, "walls/domain_upper", dimension_);
  std::vector<std::string> boundary(dimension_, "none");
  std::vector<double> edges(dimension_ * dimension_);  // vectors along x, y, z
  bool periodic = false;
  for (std::size_t k = 0; lower && upper && k < dimension_; ++k) {
    edges[k * dimension_ + k] = upper[k] - lower[k];
    if (upper[k] <= lower[k]) continue;  // the domain has no extent along an axis that is not periodic
    boundary[k] = "periodic", periodic = true;
  }
  write_box_attributes(box, boundary);
  if (!periodic) return;  // a box that is not periodic has no edges
  writer_.array(name + "/edges/value", {edges, {dimension_, dimension_}, "m"}, true);
  write_time(name + "/edges");
}

void BodiesWriter::write_time(const std::string& element) {
  if (!first_.empty()) {
    writer_.link(first_ + "/step", element + "/step");
    writer_.link(first_ + "/time", element + "/time");
    return;
  }
  first_ = element;
  const auto* steps = numbers<std::uint64_t>(state_, "clock/steps", 1);
  const auto* time = numbers<double>(state_, "clock/time", 1);
  writer_.array(element + "/step", {std::vector{steps ? *steps : 0}, {1}, "1"}, false);
  writer_.array(element + "/time", {std::vector{time ? *time : 0}, {1}, "s"}, false);
}

}  // namespace scree::state_file
