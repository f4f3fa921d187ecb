#include "verbs.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include <scree/snapshot/load_backend.hpp>

namespace scree::tool {

namespace fs = std::filesystem;

namespace {

struct RenderArguments {
  std::string source, out;
  snapshot::RenderOptions options;
};

// The particle files of a run directory or of its snapshots folder in order of time, or the one file named.
std::vector<fs::path> frames_of(const fs::path& source) {
  if (fs::is_regular_file(source)) return {source};
  const fs::path folder = fs::is_directory(source / "snapshots") ? source / "snapshots" : source;
  std::vector<fs::path> frames;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().extension() == ".vtp" && entry.path().filename().string().starts_with("particles_"))
      frames.push_back(entry.path());
  std::sort(frames.begin(), frames.end());
  if (frames.empty())
    throw Error(
        fmt::format("{}: contains no particles_*.vtp; give a run with snapshots ([snapshot] every = <s>)",
                    source.string()));
  return frames;
}

ExitStatus render(const RenderArguments& arguments) {
  const auto backend = snapshot::load_backend();
  const std::vector<fs::path> frames = frames_of(arguments.source);
  const fs::path base = fs::is_directory(arguments.source) ? fs::path(arguments.source) / "images"
                                                           : fs::path(arguments.source).parent_path();
  const fs::path out = arguments.out.empty() ? base : fs::path(arguments.out);
  for (const fs::path& frame : frames) {
    const std::string number = frame.stem().string().substr(std::string("particles_").size());
    const fs::path picture = out / fmt::format("frame_{}.png", number);
    backend->render(backend->read_frame(frame), arguments.options, picture);
    fmt::print("{}\n", picture.string());
  }
  return ExitStatus::success;
}

}  // namespace

void add_render_verb(CommandLine& line) {
  Verb verb = line.verb("render", "Redraw the snapshots of a run; needs no display");
  auto a = std::make_shared<RenderArguments>();
  const std::vector<std::string> fields(snapshot::color_fields.begin(), snapshot::color_fields.end());
  const std::vector<std::string> views(snapshot::view_names.begin(), snapshot::view_names.end());
  verb.option("source", a->source, "Run directory, or one particles_*.vtp file").required().existing_path();
  verb.option("--out", a->out, "Directory for the images; default: images/ of the run").shown_as("DIR");
  verb.option("--color-by", a->options.color_by, "Field that colours the bodies (default radius)")
      .one_of(fields);
  verb.option("--view", a->options.view, "View direction (default iso; always z in 2D)").one_of(views);
  verb.flag("--contacts", a->options.show_contacts, "Draw the contact network");
  verb.option("--width", a->options.width, "Pixels (default 1200)").between(200, 8000);
  verb.option("--height", a->options.height, "Pixels (default 900)").between(200, 8000);
  verb.footer("Example: scree render runs/first --color-by speed --contacts");
  verb.action([a] { return render(*a); });
}

}  // namespace scree::tool
