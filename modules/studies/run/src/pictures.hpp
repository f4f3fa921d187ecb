#pragma once

#include "sampler.hpp"
#include "trajectory.hpp"

#include <functional>
#include <future>
#include <memory>
#include <string>

#include <scree/pictures/backend.hpp>
#include <scree/pictures/view_range.hpp>
#include <scree/run/frame_of.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/simulation.hpp>

namespace scree::run {

// Snapshots, images and charts of a run. VTK is loaded only if the plan has snapshots or images, cairo only
// if it has charts. A thread writes a snapshot or an image while the run goes on, one at a time; Error of one
// that cannot be written comes with the next, or at the end.
class Pictures {
 public:
  // Throws Error if VTK is needed and cannot be loaded.
  Pictures(const scenario::Plan& plan, const RunDirectory& directory);

  // Writes what is due `steps` after the start of a stage. Returns the step count of the next output.
  std::uint64_t take(const Simulation& simulation, std::uint64_t steps);
  // Step count after the start of a stage at which the next output is due.
  std::uint64_t next(const Simulation& simulation, std::uint64_t steps) const;
  // What the next pictures take from the last: their frame and the range of their colours; and how many
  // frames the trajectory has. Throws Error if that of a run that goes on has not so many.
  void transfer(const StateTransfer& state);
  // Drops the frames of the trajectory that came after the state.
  void cut();
  // Writes the final state, if the plan has snapshots or images.
  void take_last(const Simulation& simulation);
  // Joins all pictures of the run, those before it went on too, if the plan has a film; what prevents it is
  // reported.
  void make_film(const std::function<void(const std::string&)>& report);
  // Draws the charts; one that cannot be drawn is reported and skipped.
  void draw_charts(const Sampler& sampler, const std::function<void(const std::string&)>& report);

 private:
  // Begins to write a file, after the last is written.
  void write(std::function<void()> file);
  // Waits until the last file is on the disk.
  void finish();
  void write_snapshot(const Simulation& simulation);
  std::vector<std::filesystem::path> images() const;
  void write_image(const Simulation& simulation);
  void draw(const scenario::ChartPlan& chart, const Sampler& sampler);
  pictures::SnapshotBackend& backend();

  const scenario::Plan& plan_;
  const RunDirectory& directory_;
  std::shared_ptr<pictures::SnapshotBackend> backend_;
  SceneBox shown_;             // by the last picture
  pictures::ViewRange range_;  // of the colours of all pictures so far
  Trajectory trajectory_;
  std::uint64_t last_snapshot_ = ~0ull, last_image_ = ~0ull;
  std::future<void> writing_;  // last: it is waited for before the others go
};

}  // namespace scree::run
