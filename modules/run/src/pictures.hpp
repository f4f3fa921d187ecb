#pragma once

#include "frame_of.hpp"
#include "sampler.hpp"

#include <functional>
#include <memory>
#include <string>

#include <scree/run/run_directory.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>
#include <scree/snapshot/backend.hpp>

namespace scree::run {

// Snapshots, images and charts of a run. VTK is loaded only when the plan asks for one of them.
class Pictures {
 public:
  // The scene at the start gives the camera its box. Throws Error where VTK is needed and cannot be loaded.
  Pictures(const scenario::Plan& plan, const Simulation& start, const RunDirectory& directory);

  // What is due so many steps after the beginning of a stage. Returns when the next is.
  std::uint64_t take(const Simulation& simulation, std::uint64_t steps);
  // The state at the end, if the plan has snapshots or images at all.
  void take_last(const Simulation& simulation);
  // Charts of the series; one that cannot be drawn is told of and left out.
  void draw_charts(const Sampler& sampler, const std::function<void(const std::string&)>& tell);

 private:
  void write_snapshot(const Simulation& simulation);
  void write_image(const Simulation& simulation);
  void draw(const scenario::ChartPlan& chart, const Sampler& sampler);
  snapshot::SnapshotBackend& backend();

  const scenario::Plan& plan_;
  const RunDirectory& directory_;
  std::shared_ptr<snapshot::SnapshotBackend> backend_;
  SceneBox box_;
  std::uint64_t last_snapshot_ = ~0ull, last_image_ = ~0ull;
};

}  // namespace scree::run
