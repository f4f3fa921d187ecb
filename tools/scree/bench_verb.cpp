#include "bench.hpp"
#include "over_ranks.hpp"
#include "program_verbs.hpp"
#include "support/study_tables.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/document/message.hpp>
#include <scree/files/csv_line.hpp>

namespace scree::tool {

namespace {

struct BenchArguments {
  std::string scene, csv;
  std::vector<std::string> overrides;
  BenchOptions options;
  PluginOptions plugins;
  bool over_ranks = false;
};

std::filesystem::path scenes_folder() {
  return data_folder(SCREE_INSTALLED_BENCH_SCENES, SCREE_BENCH_SCENES);
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(scenes_folder(), failed))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

// A file, or the name of a scene.
std::filesystem::path scene_file(const std::string& scene) {
  if (std::filesystem::is_regular_file(scene)) return scene;
  const std::filesystem::path file = scenes_folder() / (scene + ".toml");
  if (std::filesystem::exists(file)) return file;
  throw Error(fmt::format("no scene '{}'; {}", scene, document::name_cure(scene, scene_names())));
}

// Not finite without contacts.
double ns_per_contact(const BenchResult& r) { return 1e9 * r.median() / double(r.contacts); }

void print(const std::string& scene, const BenchOptions& options, const BenchResult& r) {
  const unsigned threads = options.threads;
  const auto [fastest, slowest] = std::minmax_element(r.s_per_step.begin(), r.s_per_step.end());
  fmt::print("{}: {}, {}, {}{}\n", scene, counted(r.particles, "particle"), counted(r.contacts, "contact"),
             options.ranks ? counted(options.ranks->size(), "rank") + " of " : "",
             counted(threads, "thread"));
  fmt::print("{:.4g} ms per step ({:.4g} to {:.4g} in {} of {}, starting at t = {:.4g} s)\n",
             1e3 * r.median(), 1e3 * *fastest, 1e3 * *slowest, counted(r.s_per_step.size(), "repeat"),
             counted(r.steps, "step"), r.first_time);
  fmt::print("{:.3g} million particle-steps per second", 1e-6 * double(r.particles) / r.median());
  if (r.contacts > 0) fmt::print(", {:.3g} ns per contact", ns_per_contact(r));
  fmt::print("; {} bytes per particle, {} bytes per contact\n", r.bytes_per_particle, r.bytes_per_contact);
  if (options.steps > 0)
    fmt::print("state hash {:016x} at the end, the same for any number of threads and ranks\n", r.state_hash);
  if (r.crossing_share > 0)
    fmt::print("{:.1f} % of the listed pairs are between two tiles\n", 100 * r.crossing_share);
  if (options.ranks)
    fmt::print(
        "{} bodies read from other ranks, {} bytes sent per step ({:.0f} for each of them); tiles dealt {}\n",
        r.foreign_bodies, r.bytes_sent,
        double(r.bytes_sent) / double(std::max<std::size_t>(1, r.foreign_bodies)),
        r.by_graph ? "by METIS" : "in ranges");
  double all = 0;
  for (int k = 0; k < Profile::phase_count; ++k) all += r.profile.seconds(Profile::Phase(k));
  fmt::print("time per phase{}, from one extra repeat (includes timer overhead):\n",
             options.ranks ? " on the first rank"
             : threads > 1 ? " on the first thread"
                           : "");
  for (int k = 0; k < Profile::phase_count; ++k) {
    const double seconds = r.profile.seconds(Profile::Phase(k));
    fmt::print("  {:<12} {:>9.4g} us {:>5.1f} %{}\n", Profile::names[std::size_t(k)],
               1e6 * seconds / double(r.steps), 100 * seconds / all,
               k == Profile::neighbours ? "  " + counted(r.searches, "search", "searches") : "");
  }
}

std::string csv_header() {
  std::string header =
      "version,scene,particles,contacts,threads,time,steps,repeats,s_per_step,s_per_step_fastest,"
      "s_per_step_slowest,particle_steps_per_second,ns_per_contact,bytes_per_particle,bytes_per_contact,"
      "listed_pairs,crossing_share,searches";
  for (const char* name : Profile::names) header += fmt::format(",{}_s", name);
  return header;
}

// A table that rows can be added to, and what comes before the next: its header if it is new.
struct Table {
  std::ofstream file;
  std::string before;
};

// Throws Error if it has other columns or cannot be written.
Table table_at(const std::filesystem::path& path) {
  Table t;
  t.before = csv_header() + "\n";
  std::error_code failed;
  if (std::filesystem::is_regular_file(path, failed)) {
    std::ifstream before(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(before), {});
    if (!text.empty() && text.substr(0, text.find('\n')) != csv_header())
      throw Error(
          fmt::format("{}: has other columns than this version; give a new --csv file", path.string()));
    if (!text.empty()) t.before = text.back() == '\n' ? std::string() : "\n";
  }
  t.file.open(path, std::ios::app);
  if (!t.file)
    throw Error(fmt::format("{}: cannot be written; give another --csv", path.string()), ExitStatus::failure);
  return t;
}

std::string csv_row(const std::string& scene, unsigned threads, const BenchResult& r) {
  const auto [fastest, slowest] = std::minmax_element(r.s_per_step.begin(), r.s_per_step.end());
  std::vector<std::string> cells = {SCREE_VERSION, scene};
  const auto add = [&](auto number) { cells.push_back(fmt::format("{}", number)); };
  add(r.particles), add(r.contacts), add(threads), add(r.first_time), add(r.steps), add(r.s_per_step.size());
  add(r.median()), add(*fastest), add(*slowest), add(double(r.particles) / r.median());
  cells.push_back(files::csv_number(ns_per_contact(r)));
  add(r.bytes_per_particle), add(r.bytes_per_contact);
  add(r.listed_pairs), add(r.crossing_share);
  add(r.searches);
  for (int k = 0; k < Profile::phase_count; ++k) add(r.profile.seconds(Profile::Phase(k)) / double(r.steps));
  return files::csv_line(cells);
}

ExitStatus bench(const BenchArguments& a, Ranks* ranks) {
  PluginHost host = make_host(a.plugins);
  const scenario::Plan plan = scenario::read_plan(scene_file(a.scene), a.overrides, host, study_tables());
  Table csv;
  if (!a.csv.empty()) csv = table_at(a.csv);
  const std::string name = std::filesystem::path(a.scene).stem().string();
  BenchOptions options = a.options;
  options.ranks = ranks;
  const BenchResult result = time_steps(plan, options);
  print(name, options, result);
  if (a.csv.empty()) return ExitStatus::success;
  if (!(csv.file << csv.before << csv_row(name, a.options.threads, result) << std::flush))
    throw Error(fmt::format("{}: cannot be written; free disk space or give another --csv", a.csv),
                ExitStatus::failure);
  return ExitStatus::success;
}

std::string footer() {
  return fmt::format(
      "Scenes: {}\n\n"
      "A scenario is timed with its stages, but without probes and pictures; one that ends is restarted. "
      "The\n"
      "state of a scene that changes depends on --start and --steps: give them to compare machines or "
      "versions.\n\n"
      "Phases: boundaries (walls move), integrate (bodies move), neighbours (searches and what decides on "
      "them),\n"
      "gather (copy the bodies of pairs), geometry (overlaps, relative motion), law (the plug-in), reduce (torques, "
      "sums of\n"
      "forces and energies), body_forces (plug-ins), audit (momentum)\n\n"
      "Examples: scree bench beads-4096 --threads 2 --csv bench.csv\n"
      "          mpirun -n 4 scree bench beads-102400 --ranks",
      fmt::join(scene_names(), ", "));
}

}  // namespace

void add_bench_verb(CommandLine& line) {
  Verb verb = line.verb("bench", "Measure the time per step of a scene, and per phase");
  auto a = std::make_shared<BenchArguments>();
  BenchOptions& o = a->options;
  verb.option("scene", a->scene, "Name of a scene (see below), or a scenario file").required();
  verb.option("--threads", o.threads, "Threads (default 1)").between(1, 1024);
  verb.option("--repeats", o.repeats, "Number of repeats; the median is reported (default 5)")
      .between(1, 1000);
  verb.option("--start", o.start,
              "Time in the scene to begin at, s: with one repeat that does not count (default: its start)")
      .above_zero();
  const Option seconds =
      verb.option("--seconds", o.seconds, "Approximate duration of a repeat, s (default 0.5)").above_zero();
  verb.option("--steps", o.steps, "Steps per repeat, instead of --seconds")
      .between(1, 1e12)
      .excludes(seconds);
  add_ranks_option(verb, a->over_ranks);
  verb.option("--csv", a->csv, "Append a row to this CSV file; a new file gets a header").shown_as("FILE");
  verb.option("--set", a->overrides, "Change a value of the scene").shown_as("KEY=VALUE");
  add_plugin_options(verb, a->plugins);
  verb.footer(footer);
  verb.action([a] {
    return do_over_ranks({a->over_ranks, a->options.threads, a->plugins},
                         [&](Ranks* ranks) { return bench(*a, ranks); });
  });
}

}  // namespace scree::tool
