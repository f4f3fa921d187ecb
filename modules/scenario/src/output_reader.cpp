#include "output_keys.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <scree/document/message.hpp>
#include <scree/files/text.hpp>
#include <scree/nearest.hpp>
#include <scree/pictures/render_options.hpp>
#include <scree/scenario/quantities.hpp>

namespace scree::scenario {

namespace {

Expectation read_expectation(const document::Table& t) {
  Expectation e;
  e.requirement = read(t, expect_keys.requirement);
  e.quantity = read(t, expect_keys.quantity);
  e.place = t.place(expect_keys.quantity);
  e.reference = read_optional(t, expect_keys.reference);
  e.tolerance = read_optional(t, expect_keys.tolerance);
  e.at_most = read_optional(t, expect_keys.at_most);
  e.at_least = read_optional(t, expect_keys.at_least);
  e.of_step = read(t, expect_keys.of_step);
  e.scale = read_optional(t, expect_keys.scale);
  if (e.reference.has_value() != e.tolerance.has_value())
    throw t.error(e.reference ? "reference" : "tolerance", "reference and tolerance must both be given",
                  "give both, or at_most / at_least");
  if (!e.reference && !e.at_most && !e.at_least)
    throw t.error("quantity", "the quantity has no required value",
                  "give reference and tolerance, at_most, or at_least");
  return e;
}

}  // namespace

std::vector<std::string> quantity_names(const std::vector<ProbePlan>& probes, int dimension) {
  std::vector<std::string> known = run_quantity_names();
  for (const ProbePlan& probe : probes)
    for (const std::string& column : columns_of(probe, dimension).names)
      for (const char* statistic : series_statistics)
        known.push_back(fmt::format("{}.{}.{}", probe.name, column, statistic));
  return known;
}

std::optional<std::string> quantity_problem(const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return std::nullopt;
  const auto near = nearest_word(name, known);
  const std::string cure =
      near ? fmt::format("did you mean '{}'?", *near)
           : fmt::format("give one of {}, or <probe>.<column>.<{}>", fmt::join(run_quantity_names(), ", "),
                         fmt::join(series_statistics, "|"));
  return fmt::format("no quantity '{}'; {}", files::one_line(name), cure);
}

double read_interval(const document::Table& table, const Key& key, double step) {
  const double every = table.number(key, key.range);
  if (every < 0.999 * step)
    throw table.error(
        key, fmt::format("{} = {:g} s is shorter than the time step of {:g} s", key.name, every, step),
        "increase it, or decrease time.step");
  return every;
}

namespace {

// Two numbers (SI), the lower first.
std::array<double, 2> read_range(const document::Table& table, const Key& key) {
  const std::vector<double> range = table.numbers(key, 2);
  if (range[0] >= range[1])
    throw table.error(key, fmt::format("{:g} is not below {:g}", range[0], range[1]),
                      "give the lower value first");
  return {range[0], range[1]};
}

void read_cut(const document::Table& cut, int dimension, pictures::RenderOptions& picture) {
  const Key* const axes[] = {&cut_keys.x, &cut_keys.y, &cut_keys.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!cut.optional(*axes[k])) continue;
    if (int(k) >= dimension)
      throw cut.error(*axes[k], "a scene of two dimensions has no z",
                      "remove it, or set scene.dimension = 3");
    picture.cut[k] = read_range(cut, *axes[k]);
  }
}

pictures::RenderOptions read_picture(const document::Table& t, int dimension) {
  pictures::RenderOptions picture;
  picture.color_by = read(t, snapshot_keys.color_by);
  picture.color_surfaces_by = read(t, snapshot_keys.color_surfaces_by);
  if (t.optional(snapshot_keys.color_range)) picture.color_range = read_range(t, snapshot_keys.color_range);
  if (t.has(snapshot_keys.view) && !t.is_string(snapshot_keys.view)) {
    const Vec3 direction = read_vector(t, snapshot_keys.view, 3, true);
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if (!(length > 0 && std::isfinite(length)))
      throw t.error(snapshot_keys.view, "the direction has no length", "give one such as [1, -1, 0.5]");
    picture.direction = {direction[0], direction[1], direction[2]};
  } else {
    picture.view =
        t.choice(snapshot_keys.view, {pictures::view_names.begin(), pictures::view_names.end()}, "");
  }
  picture.strong_contacts = t.is_string(snapshot_keys.contacts);
  if (picture.strong_contacts) t.choice(snapshot_keys.contacts, {"strong"}, "strong");
  picture.show_contacts = picture.strong_contacts || t.boolean(snapshot_keys.contacts, false);
  picture.show_bodies = read(t, snapshot_keys.bodies);
  picture.shadows = read(t, snapshot_keys.shadows);
  if (picture.shadows && dimension == 2)
    throw t.error(snapshot_keys.shadows, "discs are flat and have no shadows",
                  "remove it, or set scene.dimension = 3");
  picture.show_title = read(t, snapshot_keys.title);
  picture.show_time = read(t, snapshot_keys.time);
  picture.scale_bar = read(t, snapshot_keys.scale_bar);
  picture.follow_bodies = read(t, snapshot_keys.follow_bodies);
  if (const auto cut = t.optional_table(snapshot_keys.cut)) read_cut(*cut, dimension, picture);
  picture.width = int(read(t, snapshot_keys.width));
  picture.height = int(read(t, snapshot_keys.height));
  return picture;
}

}  // namespace

SnapshotPlan read_snapshot(const document::Table& root, int dimension, double step) {
  SnapshotPlan plan;
  const auto t = root.optional_table("snapshot");
  if (!t) return plan;
  if (t->optional(snapshot_keys.every)) plan.every = read_interval(*t, snapshot_keys.every, step);
  if (t->optional(snapshot_keys.image_every))
    plan.image_every = read_interval(*t, snapshot_keys.image_every, step);
  plan.sliding_work = read(*t, snapshot_keys.sliding_work);
  if (plan.sliding_work && !plan.any())
    throw t->error(snapshot_keys.sliding_work, "a map of sliding work needs files or pictures",
                   "give every or image_every = <s> too");
  plan.h5md = read(*t, snapshot_keys.h5md);
  if (plan.h5md && !plan.every)
    throw t->error(snapshot_keys.h5md, "a trajectory needs the time between its frames",
                   "give every = <s> too");
  const int rate = int(read(*t, snapshot_keys.film_rate_hz));
  if (read(*t, snapshot_keys.film)) plan.film_rate = rate;
  if (plan.film_rate && !plan.image_every)
    throw t->error(snapshot_keys.film, "a film needs pictures", "give image_every = <s> too");
  plan.picture = read_picture(*t, dimension);
  if (plan.picture.color_surfaces_by == "sliding_work" && !plan.sliding_work)
    throw t->error(snapshot_keys.color_surfaces_by, "the run keeps no sliding work",
                   "set sliding_work = true too");
  return plan;
}

void read_expectations(const document::Table& root, const StudyTables* studies, Plan& plan) {
  const std::vector<std::string> known = quantity_names(plan.probes, plan.scene.dimension);
  const auto is_of_study = [&](const std::string& quantity) {
    return !studies || std::any_of(studies->begin(), studies->end(), [&](const StudyTable& study) {
      return study.judges(quantity) && root.has(study.name);
    });
  };
  for (const document::Table& t : root.tables("expect")) {
    Expectation e = read_expectation(t);
    const auto problem = quantity_problem(e.quantity, known);
    if (problem && !is_of_study(e.quantity)) throw Error(*problem).at(e.place);
    (problem ? plan.study_expectations : plan.expectations).push_back(std::move(e));
  }
}

}  // namespace scree::scenario
