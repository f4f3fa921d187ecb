#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <scree/accuracy/report.hpp>

namespace scree::accuracy {

namespace {

using Out = std::back_insert_iterator<std::string>;

void write_settings(const Convergence& study, Out out) {
  const SettingResult* best = cheapest(study);
  const std::vector<const SettingResult*> front = pareto_front(study);
  fmt::format_to(out, "{:<20} {:>10} {:>10} {:>10} {:>11}  {}\n", "integrator", "step (s)", "steps",
                 "wall (s)", "error", "of");
  for (const SettingResult& o : study.outcomes) {
    fmt::format_to(out, "{:<20} {:>10.4g} ", traits_of(o.setting.integration).name, o.setting.step);
    if (!o.problem.empty()) {
      fmt::format_to(out, "{:>10} {:>10} {:>11}  {}\n", "-", "-", "-", o.problem);
      continue;
    }
    const bool on_front = std::find(front.begin(), front.end(), &o) != front.end();
    fmt::format_to(out, "{:>10} {:>10.3g} {:>11.3g}  {}{}\n", o.steps, o.wall_time, o.worst(),
                   study.quantities[o.worst_quantity()].name,
                   &o == best ? "   <- cheapest within the tolerance"
                   : on_front ? "   <- Pareto front"
                              : "");
  }
}

std::string number_text(const std::optional<double>& number, const char* format) {
  return number ? fmt::format(fmt::runtime(format), *number) : std::string("-");
}

// Frequency and quality are worth reading at each step, the columns of a run are in accuracy.csv.
void write_peaks(const Convergence& study, Out out) {
  for (std::size_t k = 0; k < study.quantities.size(); ++k) {
    fmt::format_to(out, "\n{}\n{:<20} {:>10} {:>14} {:>11}\n", study.quantities[k].name, "", "step (s)",
                   "value", "error");
    for (const SettingResult& o : study.outcomes)
      if (o.problem.empty())
        fmt::format_to(out, "{:<20} {:>10.4g} {:>14.9g} {:>11.3g}\n", traits_of(o.setting.integration).name,
                       o.setting.step, o.values[k], o.errors[k]);
  }
}

struct MethodRow {
  std::string name;
  std::optional<double> order, positions, longest;
};

bool write_method(const MethodRow& row, bool of_positions, Out out) {
  fmt::format_to(out, "{:<20} {:>9}", row.name, number_text(row.order, "{:.2f}"));
  if (of_positions) fmt::format_to(out, " {:>12}", number_text(row.positions, "{:.2f}"));
  fmt::format_to(out, " {:>16}\n", number_text(row.longest, "{:.4g}"));
  return row.order && (row.positions || !of_positions) && row.longest;
}

void write_methods(const Convergence& study, Out out) {
  bool complete = true;
  const auto head = [&](const std::string& of, bool of_positions) {
    fmt::format_to(out, "\n{}: observed order{}, and longest step (s) within {:g}\n", of,
                   of_positions ? " of it and of positions" : "", study.tolerance);
  };
  head("largest error", !study.of_peaks);
  for (std::size_t m = 0; m < study.orders.size(); ++m)
    complete &= write_method({traits_of(study.orders[m].integration).name, study.orders[m].of_worst,
                              study.orders[m].of_quantities.back(), study.longest_steps[m].of_worst},
                             !study.of_peaks, out);
  for (std::size_t k = 0; study.of_peaks && k < study.quantities.size(); ++k) {
    head(study.quantities[k].name, false);
    for (std::size_t m = 0; m < study.orders.size(); ++m)
      complete &= write_method({traits_of(study.orders[m].integration).name, study.orders[m].of_quantities[k],
                                std::nullopt, study.longest_steps[m].of_quantities[k]},
                               false, out);
  }
  if (!complete)
    fmt::format_to(out,
                   "-: fewer than three steps with decreasing errors; no step is within the tolerance\n");
}

void write_references(const Convergence& study, Out out) {
  if (study.of_peaks)
    fmt::format_to(out, "\nreferences\n");
  else
    fmt::format_to(out, "\ncompared at t = {:.6g} s\n", study.duration);
  constexpr std::size_t many = 12;
  const bool brief = study.quantities.size() > many;
  if (brief) fmt::format_to(out, "  {} quantities; references: see accuracy.json\n", study.quantities.size());
  const auto are_positions = [&](const Quantity& q) {
    return !study.of_peaks && &q == &study.quantities.back();
  };
  for (const Quantity& q : study.quantities)
    if (brief && !are_positions(q))
      continue;
    else if (q.closed_form)
      fmt::format_to(out, "  {}: {:.9g}, closed form\n", q.name, q.reference);
    else if (are_positions(q))
      fmt::format_to(out, "  {}: those of the extrapolated reference, uncertainty {:.2g} mean radii\n",
                     q.name, q.uncertainty);
    else
      fmt::format_to(out, "  {}: {:.9g}, extrapolated, uncertainty {:.2g}\n", q.name, q.reference,
                     q.uncertainty);
}

void append_csv(Out out, double number) { fmt::format_to(out, ",{}", number); }

}  // namespace

std::string verdict(const Convergence& study) {
  const auto describe = [](const SettingResult& o) {
    return fmt::format("{} with a step of {:.4g} s ({:.3g} s of wall time, error {:.2g})",
                       traits_of(o.setting.integration).name, o.setting.step, o.wall_time, o.worst());
  };
  if (const SettingResult* best = cheapest(study))
    return fmt::format("The cheapest setting within {:g} is {}.", study.tolerance, describe(*best));
  const SettingResult* nearest = nullptr;
  for (const SettingResult& o : study.outcomes)
    if (o.problem.empty() && (!nearest || o.worst() < nearest->worst())) nearest = &o;
  if (!nearest) return "No setting has a result.";
  return fmt::format("No setting is within {:g}; the most accurate is {}.", study.tolerance,
                     describe(*nearest));
}

std::string text_report(const Convergence& study) {
  std::string text;
  const Out out(text);
  write_settings(study, out);
  if (study.of_peaks) write_peaks(study, out);
  write_methods(study, out);
  write_references(study, out);
  if (study.horizon)
    fmt::format_to(
        out,
        "Runs diverge under refinement of the step: the reference is trustworthy until t = {:.4g} s, where "
        "all settings are compared.\n",
        *study.horizon);
  for (const std::string& note : study.notes) fmt::format_to(out, "{}\n", note);
  if (study.interrupted) fmt::format_to(out, "Interrupted: not all settings were run.\n");
  fmt::format_to(out, "{}\n", verdict(study));
  return text;
}

std::string csv_report(const Convergence& study) {
  std::string text = "integrator,step_s,steps,wall_s,worst_error";
  const Out out(text);
  for (const Quantity& q : study.quantities) fmt::format_to(out, ",{0},{0}_error", q.name);
  fmt::format_to(out, ",problem\n");
  for (const SettingResult& o : study.outcomes) {
    fmt::format_to(out, "{},{},{},{}", traits_of(o.setting.integration).name, o.setting.step, o.steps,
                   o.wall_time);
    append_csv(out, o.problem.empty() ? o.worst() : NAN);
    for (std::size_t k = 0; k < study.quantities.size(); ++k) {
      append_csv(out, o.problem.empty() ? o.values[k] : NAN);
      append_csv(out, o.problem.empty() ? o.errors[k] : NAN);
    }
    std::string problem = o.problem;
    std::replace(problem.begin(), problem.end(), '"', '\'');
    fmt::format_to(out, ",{}\n", problem.empty() ? "" : fmt::format("\"{}\"", problem));
  }
  return text;
}

}  // namespace scree::accuracy
