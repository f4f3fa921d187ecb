#include "verbs.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>

#include <scree/scenario/message.hpp>
#include <scree/scenario/set_up.hpp>

namespace scree::tool {

namespace {

struct BenchArguments {
  std::string scene, csv;
  std::vector<std::string> overrides;
  unsigned threads = 1, repeats = 5;
  double seconds = 0.5;
  PluginOptions plugins;
};

// What one benchmark came to.
struct Measurement {
  std::string scene, precision;
  std::size_t particles, contacts, bytes_per_particle, bytes_per_contact;
  unsigned threads;
  std::uint64_t steps;
  double s_per_step;
  Profile profile;  // of the last repeat
  double profiled_steps;
  std::uint64_t searches;  // for neighbours in these
};

// A file, or the name of a scene of tools/bench/scenes.
std::filesystem::path scene_file(const std::string& scene) {
  if (std::filesystem::exists(scene)) return scene;
  const std::filesystem::path folder = SCREE_BENCH_SCENES, file = folder / (scene + ".toml");
  if (std::filesystem::exists(file)) return file;
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  throw Error(fmt::format("no scene '{}'; {}", scene, scenario::name_cure(scene, names)));
}

double run_for(Simulation& simulation, std::uint64_t steps) {
  const auto start = std::chrono::steady_clock::now();
  simulation.run(steps, [] { return true; });
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Measurement measure(const scenario::Plan& plan, const BenchArguments& a) {
  const auto simulation = scenario::set_up(plan, a.threads);
  Simulation& s = *simulation;
  // Warm caches, fill lists, and see how many steps make a repeat.
  std::uint64_t steps = 1;
  double wall = run_for(s, steps);
  while (wall < 0.2 * a.seconds) wall = run_for(s, steps *= 2);
  steps = std::max<std::uint64_t>(1, std::uint64_t(double(steps) * a.seconds / wall));
  std::vector<double> each;
  for (unsigned n = 0; n < a.repeats; ++n) each.push_back(run_for(s, steps) / double(steps));
  std::nth_element(each.begin(), each.begin() + std::ptrdiff_t(each.size() / 2), each.end());

  Measurement m{std::filesystem::path(a.scene).stem().string(),
                plan.scene.precision == Precision::mixed ? "mixed" : "double",
                s.particles().size(),
                s.contact_list().size(),
                s.footprint().bytes_per_body,
                s.footprint().bytes_per_pair,
                a.threads,
                steps,
                each[each.size() / 2],
                {},
                double(steps),
                s.rebuilds()};
  s.measure(&m.profile);
  run_for(s, steps);
  m.searches = s.rebuilds() - m.searches;
  return m;
}

void print(const Measurement& m) {
  fmt::print("{}: {} particles, {} contacts, {}, {} thread{}\n", m.scene, m.particles, m.contacts,
             m.precision, m.threads, m.threads > 1 ? "s" : "");
  fmt::print("{:.4g} ms a step, {:.3g} million particle-steps a second, {:.3g} ns a contact\n",
             1e3 * m.s_per_step, 1e-6 * double(m.particles) / m.s_per_step,
             1e9 * m.s_per_step / double(std::max<std::size_t>(1, m.contacts)));
  fmt::print("{} bytes a particle, {} bytes a contact\n", m.bytes_per_particle, m.bytes_per_contact);
  double all = 0;
  for (int k = 0; k < Profile::phase_count; ++k) all += m.profile.seconds(Profile::Phase(k));
  for (int k = 0; k < Profile::phase_count; ++k) {
    const double seconds = m.profile.seconds(Profile::Phase(k));
    fmt::print("  {:<12} {:>9.4g} us {:>5.1f} %{}\n", Profile::names[std::size_t(k)],
               1e6 * seconds / m.profiled_steps, 100 * seconds / all,
               k == Profile::neighbours ? fmt::format("  {} in {} steps", m.searches, m.profiled_steps) : "");
  }
}

std::string csv_header() {
  std::string header =
      "scene,precision,particles,contacts,threads,steps,s_per_step,particle_steps_per_second,ns_per_contact,"
      "bytes_per_particle,bytes_per_contact";
  for (const char* name : Profile::names) header += fmt::format(",{}_s", name);
  return header;
}

void write_csv(const Measurement& m, const std::filesystem::path& file) {
  const std::string header = csv_header();
  std::string first;
  if (std::ifstream before(file); before && std::getline(before, first) && first != header)
    throw Error(
        fmt::format("{}: has other columns than this version writes; give a new --csv", file.string()));
  std::ofstream out(file, std::ios::app);
  if (first.empty()) out << header << "\n";
  out << fmt::format("{},{},{},{},{},{},{},{},{},{},{}", m.scene, m.precision, m.particles, m.contacts,
                     m.threads, m.steps, m.s_per_step, double(m.particles) / m.s_per_step,
                     1e9 * m.s_per_step / double(std::max<std::size_t>(1, m.contacts)), m.bytes_per_particle,
                     m.bytes_per_contact);
  for (int k = 0; k < Profile::phase_count; ++k)
    out << fmt::format(",{}", m.profile.seconds(Profile::Phase(k)) / m.profiled_steps);
  out << "\n";
  out.close();
  if (!out)
    throw Error(fmt::format("{}: cannot be written; free disk space or give another --csv", file.string()),
                ExitStatus::failure);
}

ExitStatus bench(const BenchArguments& a) {
  PluginHost host = make_host(a.plugins);
  const Measurement m = measure(scenario::read_plan(scene_file(a.scene), a.overrides, host), a);
  print(m);
  if (!a.csv.empty()) write_csv(m, a.csv);
  return ExitStatus::success;
}

}  // namespace

void add_bench_verb(CLI::App& app, ExitStatus& status) {
  CLI::App* verb = app.add_subcommand("bench", "Time steps of a scene, and where the time goes");
  auto a = std::make_shared<BenchArguments>();
  verb->add_option("scene", a->scene, "Name of a scene in tools/bench/scenes, or a scenario file")
      ->required();
  verb->add_option("--threads", a->threads, "Threads (default 1)")->check(CLI::Range(1u, 1024u));
  verb->add_option("--repeats", a->repeats, "Repeats, of which the median counts (default 5)")
      ->check(CLI::Range(1u, 1000u));
  verb->add_option("--seconds", a->seconds, "About how long a repeat takes, s (default 0.5)")
      ->check(positive_and_finite);
  verb->add_option("--csv", a->csv, "File that a row is added to, with a header if it is new")
      ->type_name("FILE");
  verb->add_option("--set", a->overrides, "Change a value of the scene")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_plugin_options(*verb, a->plugins);
  verb->footer("Example: scree bench beads-4096 --threads 2 --csv bench.csv");
  verb->callback([a, &status] { status = bench(*a); });
}

}  // namespace scree::tool
