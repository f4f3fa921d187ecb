#include "pictures.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <scree/charts/draw_chart.hpp>
#include <scree/error.hpp>
#include <scree/pictures/film.hpp>
#include <scree/pictures/frame_files.hpp>
#include <scree/pictures/load_backend.hpp>
#include <scree/scenario/charts.hpp>
#include <scree/threads.hpp>

namespace scree::run {

Pictures::Pictures(const scenario::Plan& plan, const RunDirectory& directory)
    : plan_(plan), directory_(directory), range_(plan.snapshot.picture.color_by), trajectory_(directory) {
  if (plan.snapshot.any()) backend();
}

pictures::SnapshotBackend& Pictures::backend() {
  if (!backend_) backend_ = pictures::load_backend();
  return *backend_;
}

std::uint64_t Pictures::take(const Simulation& s, std::uint64_t steps) {
  const auto due = [&](const std::optional<double>& every) {
    return every && is_due(steps, *every, s.step_length());
  };
  if (due(plan_.snapshot.every)) write_snapshot(s);
  if (due(plan_.snapshot.image_every)) write_image(s);
  return next(s, steps);
}

std::uint64_t Pictures::next(const Simulation& s, std::uint64_t steps) const {
  const auto next = [&](const std::optional<double>& every) {
    return every ? next_due(steps, *every, s.step_length()) : never;
  };
  return std::min(next(plan_.snapshot.every), next(plan_.snapshot.image_every));
}

void Pictures::transfer(const StateTransfer& state) {
  if (writing_.valid()) writing_.wait();  // what a state lists is there; an error comes with the next file
  std::vector<double> colors;
  if (const auto& range = range_.color_extent()) colors.assign(range->begin(), range->end());
  state.numbers("lower", "m", shown_.lower.data(), shown_.lower.size());
  state.numbers("upper", "m", shown_.upper.data(), shown_.upper.size());
  state.rows("colors", "", colors);
  state.value("last_snapshot", "1", last_snapshot_);
  state.value("last_image", "1", last_image_);
  if (state.restoring() && colors.size() == 2) range_.extend_colors({colors[0], colors[1]});
  if (plan_.snapshot.h5md) trajectory_.transfer(state.below("trajectory"));
}

void Pictures::cut() {
  if (plan_.snapshot.h5md) trajectory_.cut();
}

void Pictures::take_last(const Simulation& s) {
  if (plan_.snapshot.every) write_snapshot(s);
  if (plan_.snapshot.image_every) write_image(s);
  finish();
}

void Pictures::write(std::function<void()> file) {
  finish();
  writing_ = in_background(std::move(file));
}

void Pictures::finish() {
  if (writing_.valid()) writing_.get();
}

void Pictures::write_snapshot(const Simulation& s) {
  if (s.steps() == last_snapshot_) return;
  last_snapshot_ = s.steps();
  const auto add_kind = [&](const char* kind) {
    directory_.add("snapshots/" + pictures::frame_file(kind, s.steps()));
    directory_.add("snapshots/" + pictures::frame_index(kind));
  };
  for (const char* kind : pictures::frame_kinds) add_kind(kind);
  if (s.surfaces().size() > 0) add_kind(pictures::surface_kind);
  write([this, frame = frame_of(s, plan_.title, scene_box(s), plan_.snapshot.picture.color_by)] {
    backend().write_frame(frame, directory_.path() / "snapshots");
  });
  if (plan_.snapshot.h5md) trajectory_.add(s);
}

void Pictures::write_image(const Simulation& s) {
  if (s.steps() == last_image_) return;
  last_image_ = s.steps();
  pictures::RenderOptions options = plan_.snapshot.picture;
  options.time_spacing = *plan_.snapshot.image_every;
  shown_ = next_view(shown_, scene_box(s));
  pictures::Frame frame = frame_of(s, plan_.title, shown_, options.color_by);
  range_.add_colors(frame);
  if (!options.color_range) options.color_range = range_.colors();
  write([this, frame = std::move(frame), options,
         file = directory_.add(fmt::format("images/frame_{:010}.png", s.steps()))] {
    backend().render(frame, options, file);
  });
}

std::vector<std::filesystem::path> Pictures::images() const {
  std::vector<std::filesystem::path> all;
  for (const auto& entry : std::filesystem::directory_iterator(directory_.path() / "images"))
    if (directory_.written().contains("images/" + entry.path().filename().string()))
      all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

void Pictures::make_film(const std::function<void(const std::string&)>& report) {
  if (!plan_.snapshot.film_rate) return;
  constexpr const char* name = "film.mp4";
  const std::string folder = directory_.path().string();
  try {
    if (!pictures::has_ffmpeg())
      throw Error(
          fmt::format("{0}; apt install ffmpeg, then ffmpeg -framerate {1} -pattern_type glob -i "
                      "'{2}/images/frame_*.png' -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p {2}/{3}",
                      pictures::no_ffmpeg, *plan_.snapshot.film_rate, folder, name));
    pictures::write_film(images(), *plan_.snapshot.film_rate, directory_.add(name));
  } catch (const std::exception& error) {
    report(fmt::format("{} was not made: {}", name, error.what()));
  }
}

void Pictures::draw(const scenario::ChartPlan& plan, const Sampler& sampler) {
  const auto column = [&](const std::string& probe, const std::string& name) {
    const Series& series = sampler.series(probe);
    return series.rows() > 0 ? series.column(name) : std::vector<double>();
  };
  const charts::ChartSpec chart = scenario::chart_of(plan, column);
  charts::draw_chart(chart, directory_.add("charts/" + plan.file_name()));
}

void Pictures::draw_charts(const Sampler& sampler, const std::function<void(const std::string&)>& report) {
  for (const scenario::ChartPlan& chart : plan_.charts) {
    try {
      draw(chart, sampler);
    } catch (const std::exception& error) {
      if (report)
        report(fmt::format(
            "chart '{}' was not drawn: {}; scree chart {} --set chart.{}.KEY=VALUE draws it again",
            chart.name, error.what(), directory_.path().string(), chart.name));
    }
  }
}

}  // namespace scree::run
