#include "scree/cycles/rattlers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/csv_rows.hpp>

namespace scree::cycles {

namespace {

namespace fs = std::filesystem;
using files::CsvRows;

constexpr std::string_view touched = "touched_", last_touch = "last_touch_";

// The two columns of a body, and their values at each minimum.
struct Track {
  long long id = 0;
  std::size_t touched_column = 0, last_column = 0;
  std::vector<double> observations;  // in which it touched, so far
  std::vector<double> last;          // (s) time of the last touch
};

std::vector<Track> tracks_of(const CsvRows& rows) {
  std::vector<Track> tracks;
  for (std::size_t c = 0; c < rows.columns().size(); ++c) {
    const std::string& name = rows.columns()[c].name;
    if (!name.starts_with(touched)) continue;
    const std::string id = name.substr(touched.size());
    Track track;
    const auto end = std::from_chars(id.data(), id.data() + id.size(), track.id);
    if (end.ec != std::errc{} || end.ptr != id.data() + id.size()) continue;
    track.touched_column = c;
    track.last_column = rows.column(std::string(last_touch) + id);
    tracks.push_back(std::move(track));
  }
  std::sort(tracks.begin(), tracks.end(), [](const Track& a, const Track& b) { return a.id < b.id; });
  return tracks;
}

// Reads the rows at the minima. Returns the number of observations at each.
std::vector<double> read_tracks(CsvRows& rows, const fs::path& file, const std::vector<double>& minima,
                                std::vector<Track>& tracks) {
  constexpr double slack = 1e-6;  // over the period, as for strains
  const double near = minima.size() > 1 ? slack * (minima[1] - minima[0]) : 0;
  const std::size_t all = rows.column("observations");
  std::vector<double> observations;
  while (observations.size() < minima.size() && rows.next()) {
    if (rows.number(0) < minima[observations.size()] - near) continue;
    if (rows.number(0) > minima[observations.size()] + near) break;
    observations.push_back(rows.number(all));
    for (Track& track : tracks) {
      track.observations.push_back(rows.number(track.touched_column));
      track.last.push_back(rows.number(track.last_column));
    }
  }
  if (observations.size() < minima.size())
    throw Error(
        fmt::format("{}: there is no row at {} s, a minimum of the load; give the probe that has them with "
                    "--touching, `every` of it the period and `stages` that of the load",
                    file.string(), minima[observations.size()]));
  return observations;
}

}  // namespace

Rattlers read_rattlers(const fs::path& file, const std::vector<double>& minima, std::size_t drop) {
  CsvRows rows(file);
  std::vector<Track> tracks = tracks_of(rows);
  if (tracks.empty())
    throw Error(
        fmt::format("{}: there is no column touched_<id>; name a probe of the kind touching", file.string()));
  const std::vector<double> observations = read_tracks(rows, file, minima, tracks);
  const double counted = observations.back() - observations[drop];
  Rattlers found;
  std::erase_if(tracks, [&](const Track& track) {
    const double share = (track.observations.back() - track.observations[drop]) / counted;
    if (share < Rattler::seldom) found.bodies.push_back({track.id, share});
    return !(share < Rattler::seldom);
  });
  for (std::size_t n = 0; n < minima.size() && !tracks.empty(); ++n) {
    const auto latest = std::max_element(
        tracks.begin(), tracks.end(), [n](const Track& a, const Track& b) { return a.last[n] < b.last[n]; });
    found.touches.push_back({latest->id, minima[n] - latest->last[n]});
  }
  return found;
}

}  // namespace scree::cycles
