#include "trajectory_file.hpp"

#include "bodies_writer.hpp"
#include "file_writer.hpp"
#include "trajectory_reader.hpp"

#include <algorithm>
#include <vector>

namespace scree::state_file {
namespace {

const std::string all = "particles/all/", box = "particles/all/box", edges = "box/edges", first = "position";
constexpr std::size_t no_user_block = 0;

bool is_periodic(const TrajectoryFrame& frame) {
  return std::any_of(frame.periodic.begin(), frame.periodic.end(), [](bool axis) { return axis; });
}

// What all frames share.
void write_fixed(FileWriter& writer, const TrajectoryFrame& frame) {
  write_h5md_group(writer);
  std::vector<std::string> boundary;
  for (int k = 0; k < frame.dimension; ++k)
    boundary.emplace_back(frame.periodic[std::size_t(k)] ? "periodic" : "none");
  write_box_attributes(writer.group(box), boundary);
  for (const auto& [name, array] : frame.fixed) writer.array(all + name, array, false);
}

StateArray edges_of(const TrajectoryFrame& frame) {
  const std::size_t d = std::size_t(frame.dimension);
  std::vector<double> vectors(d * d);  // along x, y, z
  for (std::size_t k = 0; k < d; ++k) vectors[k * d + k] = frame.edges[k];
  return {vectors, {d, d}, "m"};
}

// All elements are of the same times, so that they share their datasets.
void append_element(FileWriter& writer, const std::string& name, const StateArray& array,
                    std::uint64_t frame) {
  writer.append(all + name + "/value", array, frame, name == first ? "length in m" : "");
  if (frame > 0 || name == first) return;
  for (const char* when : {"/step", "/time"}) writer.link(all + first + when, all + name + when);
}

}  // namespace

void append_to_trajectory(const std::filesystem::path& file, const TrajectoryFrame& now,
                          std::uint64_t frame) {
  FileWriter writer = frame == 0 ? FileWriter(file, no_user_block) : FileWriter::existing(file);
  if (frame == 0) write_fixed(writer, now);
  writer.append(all + first + "/step", {std::vector{now.step}, {}, "1"}, frame, "");
  writer.append(all + first + "/time", {std::vector{now.time}, {}, "s"}, frame, "");
  if (is_periodic(now)) append_element(writer, edges, edges_of(now), frame);
  for (const auto& [name, array] : now.moving) append_element(writer, name, array, frame);
  writer.close();
}

void check_trajectory(const std::filesystem::path& file, std::uint64_t frames) {
  const TrajectoryReader reader(file);
  for (const std::string& name : reader.moving()) reader.check(name + "/value", frames);
  for (const char* when : {"/step", "/time"}) reader.check(first + when, frames);
  if (reader.has(edges)) reader.check(edges + "/value", frames);
}

TrajectoryFrame frame_of_trajectory(const std::filesystem::path& file, std::uint64_t frame) {
  const TrajectoryReader reader(file);
  TrajectoryFrame now;
  now.step = std::get<std::vector<std::uint64_t>>(reader.array(first + "/step", frame).values).at(0);
  now.time = std::get<std::vector<double>>(reader.array(first + "/time", frame).values).at(0);
  for (const std::string& name : reader.moving()) now.moving[name] = reader.array(name + "/value", frame);
  now.dimension = int(now.moving.at(first).shape.at(1));
  if (frame == 0)
    for (const std::string& name : reader.fixed()) now.fixed[name] = reader.array(name, std::nullopt);
  const std::vector<std::string> boundary = reader.boundary();
  for (std::size_t k = 0; k < std::min<std::size_t>(3, boundary.size()); ++k)
    now.periodic[k] = boundary[k] == "periodic";
  if (!is_periodic(now)) return now;
  const StateArray vectors = reader.array(edges + "/value", frame);
  for (std::size_t k = 0; k < std::size_t(now.dimension); ++k)
    now.edges[k] = std::get<std::vector<double>>(vectors.values).at(k * std::size_t(now.dimension) + k);
  return now;
}

}  // namespace scree::state_file
