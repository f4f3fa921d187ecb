#include "program_verbs.hpp"
#include "support/output_file.hpp"
#include "support/snapshot_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>

#include <scree/files/temporary_file.hpp>
#include <scree/files/text_file.hpp>
#include <scree/pictures/film.hpp>
#include <scree/pictures/load_backend.hpp>
#include <scree/pictures/view_range.hpp>
#include <scree/run/written_files.hpp>

namespace scree::tool {

namespace fs = std::filesystem;

namespace {

struct RenderArguments {
  std::string source, out, movie, color_range, view;
  std::vector<std::string> cut;
  bool no_bodies = false, no_title = false, no_time = false;
  int frames_per_second = 25;
  bool overwrite = false;
  pictures::RenderOptions options;
};

// particles_0000000100.vtp becomes frame_0000000100.png, any other name x.vtp x.png.
std::string picture_name(const fs::path& frame) {
  constexpr std::string_view prefix = "particles_";
  const std::string stem = frame.stem().string();
  return (stem.starts_with(prefix) ? "frame_" + stem.substr(prefix.size()) : stem) + ".png";
}

// Throws Error for a file that is there and may not be replaced.
void check_replaced(const fs::path& file, bool overwrite, const char* problem) {
  std::error_code failed;
  if (overwrite || !fs::exists(fs::symlink_status(file, failed))) return;
  throw Error(fmt::format("{}: {}", file.string(), problem));
}

// Numbers separated by commas; empty unless all are finite numbers.
std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  const char* next = text.c_str();
  while (true) {
    char* end = nullptr;
    numbers.push_back(std::strtod(next, &end));
    if (end == next || !std::isfinite(numbers.back())) return {};
    if (*end == 0) return numbers;
    if (*end != ',') return {};
    next = end + 1;
  }
}

// "LOW,HIGH".
std::array<double, 2> range_of(const std::string& option, const std::string& text) {
  const std::vector<double> range = numbers_of(text);
  if (range.size() != 2 || range[0] >= range[1])
    throw Error(
        fmt::format("{} {}: is not a range; give two numbers (SI) as 0,0.5, the lower first", option, text));
  return {range[0], range[1]};
}

// Each "x=LOW,HIGH".
void set_cut(const std::vector<std::string>& cuts, pictures::RenderOptions& options) {
  for (const std::string& cut : cuts) {
    if (cut.size() < 3 || cut[1] != '=' || cut[0] < 'x' || cut[0] > 'z')
      throw Error(fmt::format("--cut {}: names no axis; give x=LOW,HIGH, y=LOW,HIGH or z=LOW,HIGH (m)", cut));
    if (options.cut[std::size_t(cut[0] - 'x')])
      throw Error(fmt::format("--cut {}: is the second along {}; give one range for each axis", cut, cut[0]));
    options.cut[std::size_t(cut[0] - 'x')] = range_of("--cut " + cut.substr(0, 1), cut.substr(2));
  }
}

// A name, or "X,Y,Z".
void set_view(const std::string& view, pictures::RenderOptions& options) {
  const std::vector<double> direction = numbers_of(view);
  if (direction.size() == 3)
    options.direction = {direction[0], direction[1], direction[2]};
  else
    options.view = view;
}

pictures::RenderOptions options_of(const RenderArguments& arguments) {
  pictures::RenderOptions options = arguments.options;
  if (!arguments.color_range.empty()) options.color_range = range_of("--color-range", arguments.color_range);
  options.show_contacts = options.show_contacts || options.strong_contacts;
  options.show_bodies = !arguments.no_bodies;
  options.show_title = !arguments.no_title;
  options.show_time = !arguments.no_time;
  set_cut(arguments.cut, options);
  set_view(arguments.view, options);
  return options;
}

// What all pictures have in common, from a first look at every frame.
struct Common {
  pictures::ViewRange view;
  std::vector<double> times = {};  // (s)
  bool has_bodies = false;         // in the cut
  // The first ones, as many as fit in about 200 MB; the rest is read again.
  std::vector<pictures::Frame> frames = {};

  // Time between pictures (s); 0 of one. The last may follow its predecessor at once.
  double spacing() const {
    return times.size() < 2 ? 0 : (times.back() - times.front()) / double(times.size() - 1);
  }
};

Common common_of(const std::vector<fs::path>& frames, const pictures::RenderOptions& options,
                 pictures::SnapshotBackend& backend) {
  Common common = {pictures::ViewRange(options.color_by)};
  std::size_t room = 1'000'000;  // bodies and contacts, of 200 bytes each
  for (const fs::path& file : frames) {
    pictures::Frame frame = backend.read_frame(file);
    common.view.add_box(frame);
    common.view.add_colors(frame);
    common.times.push_back(frame.time);
    for (std::size_t i = 0; i < frame.particle_count() && !common.has_bodies; ++i)
      common.has_bodies = pictures::reaches_into(options.cut, frame.position.data() + 3 * i, frame.radius[i]);
    const std::size_t rows = frame.particle_count() + frame.contact_count();
    room = rows <= room ? room - rows : 0;
    if (room > 0) common.frames.push_back(std::move(frame));
  }
  if (!common.has_bodies && options.cut != pictures::Cut{})
    throw Error("--cut: no body lies there in any snapshot; give a range that holds some");
  return common;
}

// Where pictures are drawn. Those of a run are listed there, so that they are removed with it, and may be
// drawn again; other files are replaced only if that is asked for.
class Pictures {
 public:
  explicit Pictures(const RenderArguments& arguments) : overwrite_(arguments.overwrite) {
    const fs::path source = arguments.source;
    const bool of_run = is_folder(source);
    out_ = !arguments.out.empty() ? fs::path(arguments.out)
           : of_run               ? source / "images"
                                  : source.parent_path();
    std::error_code failed;
    if (of_run && fs::exists(source / run::WrittenFiles::file_name, failed) &&
        (arguments.out.empty() || fs::equivalent(out_, source / "images", failed)))
      list_.emplace(source);
  }

  // Throws Error for a picture of this frame that is there already.
  void check(const fs::path& frame) const {
    if (list_ && list_->contains(listed(frame))) return;
    const fs::path picture = out_ / picture_name(frame);
    if (list_)
      check_replaced(picture, false,
                     "is there and was not written by a run; move it elsewhere, or give another --out");
    else
      check_replaced(picture, overwrite_, "is there already; give another --out, or --overwrite");
  }

  void create_folder() const {
    std::error_code failed;
    if (!out_.empty()) fs::create_directories(out_, failed);
    if (failed)
      throw Error(
          fmt::format("{}: cannot be created ({}); give another --out", out_.string(), failed.message()));
  }

  // Returns the path of the picture of a file.
  fs::path draw(const fs::path& file, const pictures::Frame& frame, const pictures::RenderOptions& options,
                pictures::SnapshotBackend& backend) {
    const fs::path picture = out_ / picture_name(file);
    // A run that goes on meanwhile removes what is listed after its state, so that it is listed only when it
    // is there.
    std::optional<files::TemporaryFile> drawn;
    if (list_) drawn.emplace();
    backend.render(frame, options, drawn ? fs::path(drawn->path) : picture);
    if (list_) list_->put(listed(file), files::read_text(drawn->path));
    return picture;
  }

 private:
  static std::string listed(const fs::path& frame) { return "images/" + picture_name(frame); }

  fs::path out_;
  bool overwrite_;
  std::optional<run::WrittenFiles> list_;
};

// Throws Error unless the movie can be made.
void check_movie(const RenderArguments& arguments) {
  check_output_file("--movie", arguments.movie, arguments.overwrite);
  if (fs::path(arguments.movie).extension() != ".mp4")
    throw Error("--movie " + arguments.movie, "is not a name of a movie", "give one that ends in .mp4");
  if (!pictures::has_ffmpeg())
    throw Error(
        fmt::format("--movie: {}; install it (apt install ffmpeg), or leave --movie out and join the "
                    "pictures elsewhere",
                    pictures::no_ffmpeg));
}

ExitStatus render(const RenderArguments& arguments) {
  pictures::RenderOptions options = options_of(arguments);
  if (!arguments.movie.empty()) check_movie(arguments);
  const auto backend = pictures::load_backend();
  const std::vector<fs::path> frames = snapshot_files(arguments.source);
  Pictures places(arguments);
  for (const fs::path& file : frames) places.check(file);
  Common common = common_of(frames, options, *backend);
  if (!options.color_range) options.color_range = common.view.colors();
  options.time_spacing = common.spacing();
  std::vector<fs::path> drawn;
  places.create_folder();
  for (std::size_t k = 0; k < frames.size(); ++k) {
    pictures::Frame frame =
        k < common.frames.size() ? std::move(common.frames[k]) : backend->read_frame(frames[k]);
    frame.lower = common.view.lower(), frame.upper = common.view.upper();
    drawn.push_back(places.draw(frames[k], frame, options, *backend));
    fmt::print("{}\n", drawn.back().string());
  }
  if (arguments.movie.empty()) return ExitStatus::success;
  pictures::write_film(drawn, arguments.frames_per_second, arguments.movie);
  fmt::print("{}\n", arguments.movie);
  return ExitStatus::success;
}

}  // namespace

void add_render_verb(CommandLine& line) {
  Verb verb = line.verb("render", "Redraw the snapshots of a run; needs no display");
  auto a = std::make_shared<RenderArguments>();
  const std::vector<std::string> fields(pictures::color_fields.begin(), pictures::color_fields.end());
  verb.option("source", a->source, "Run directory, or one particles_*.vtp file").required().existing_path();
  verb.option("--out", a->out, "Directory for the images; default: images/ of the run").shown_as("DIR");
  verb.option("--color-by", a->options.color_by, "Field that colours the bodies (default radius)")
      .one_of(fields);
  const std::vector<std::string> maps(pictures::surface_maps_shown.begin(),
                                      pictures::surface_maps_shown.end());
  verb.option("--color-surfaces-by", a->options.color_surfaces_by,
              "Map on the facets of cylinders, meshes and other surfaces (default none)")
      .one_of(maps);
  verb.option("--color-range", a->color_range,
              "Values at the ends of the colour bar, SI; default: the range in all snapshots")
      .shown_as("LOW,HIGH");
  verb.option("--view", a->view,
              "iso, x, y, z, or the direction to the viewer as 1,-1,0.5 (default iso; always z in 2D)")
      .shown_as("VIEW");
  verb.flag("--contacts", a->options.show_contacts, "Draw the contact network");
  verb.flag("--strong-contacts", a->options.strong_contacts,
            "Draw the contacts above the mean normal force alone, coloured by it");
  verb.flag("--no-bodies", a->no_bodies, "Draw no bodies");
  verb.option("--cut", a->cut,
              "Draw only what lies in this range (m), as y=0.01,0.02, with bodies cut there; several times")
      .shown_as("AXIS=LOW,HIGH");
  verb.flag("--follow-bodies", a->options.follow_bodies,
            "The frame holds the bodies of each picture, not all walls");
  verb.flag("--shadows", a->options.shadows, "Darken the hollows between bodies, in 3D");
  verb.flag("--scale-bar", a->options.scale_bar, "Draw a bar of a round length");
  verb.flag("--no-title", a->no_title, "Write no title");
  verb.flag("--no-time", a->no_time, "Write no time");
  verb.option("--width", a->options.width, "Pixels (default 1200)").between(200, 8000);
  verb.option("--height", a->options.height, "Pixels (default 900)").between(200, 8000);
  verb.option("--movie", a->movie, "Also join the pictures to a movie, with ffmpeg").shown_as("FILE.mp4");
  verb.option("--rate", a->frames_per_second, "Pictures per second of the movie (default 25)")
      .between(1, 240);
  verb.flag("--overwrite", a->overwrite,
            "Replace pictures in --out and a movie; those in images/ of a run are drawn again without it");
  verb.moved(
      "--charts",
      "--charts: charts have their own verb; give scree chart DIRECTORY, with the same --set and --scenario");
  verb.footer("Example: scree render runs/first --color-by speed --contacts --movie first.mp4");
  verb.action([a] { return render(*a); });
}

}  // namespace scree::tool
