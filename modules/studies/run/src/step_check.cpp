#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include <scree/run/step_check.hpp>
#include <scree/step_guard.hpp>
#include <scree/told_apart.hpp>

namespace scree::run {

namespace {

// Of a step that is computed from the limit with which it is compared.
constexpr double round_off = 1e-12;

// Rounded down to two digits, so that the printed number is allowed.
double rounded_down(double step) {
  const double unit = std::pow(10, std::floor(std::log10(step)) - 1);
  return std::floor(step / unit * (1 + round_off)) * unit;
}

// Error without a place if the time step is above its limit.
std::optional<Error> too_long(const Simulation& s) {
  const StepLimit limit = shortest_limit(s);
  if (s.step_length() <= limit.longest_step * (1 + round_off)) return std::nullopt;
  const std::string_view plural = limit.cause.starts_with("the contacts") ? "" : "s";
  if (!(limit.longest_step > 0))
    return Error("", fmt::format("no time step is short enough: {} allow{} none", limit.cause, plural),
                 "check speeds, masses and viscosities");
  const double contact = s.min_steps_per_contact() * s.step_length();
  const std::string step = told_apart(s.step_length(), limit.longest_step)[0];
  const std::string longest = told_apart(s.step_length(), limit.longest_step, 4)[1];
  return Error("",
               fmt::format("the time step of {} s is too long: {} allow{} {} s at most", step, limit.cause,
                           plural, longest),
               fmt::format("use time.step = {:.2g} or less{}",
                           rounded_down(std::min(contact / 50, limit.longest_step)),
                           contact / 50 < limit.longest_step ? " (50 steps per contact)" : ""));
}

}  // namespace

std::string describe_step(const Simulation& s) {
  return fmt::format(
      "time step {:.4g} s, {:.3g} steps in the shortest contact, {:.2g} of the longest stable step",
      s.step_length(), s.min_steps_per_contact(), s.step_length() / shortest_limit(s).longest_step);
}

std::optional<std::string> step_warning(const Simulation& s) {
  constexpr double few = 20;  // with fewer steps, errors of contacts are several per cent
  if (const auto problem = too_long(s)) return problem->what();
  if (s.min_steps_per_contact() >= few * (1 - round_off)) return std::nullopt;
  return fmt::format(
      "the shortest contact takes {} time steps; use {:g} or more, 50 for errors of 0.1 % unless damping is "
      "strong",
      told_apart(s.min_steps_per_contact(), few, 3)[0], few);
}

std::optional<Error> step_problem(const Simulation& s) {
  const auto problem = too_long(s);
  if (!problem) return std::nullopt;
  return Error("", problem->problem(), problem->cure() + ", or time.step_guard = false to run it anyway");
}

void check_step(const scenario::Plan& plan, const Simulation& s) {
  const auto problem = plan.step_guard ? step_problem(s) : std::nullopt;
  if (problem) throw problem->at(fmt::format("t = {:g} s", s.time()), ExitStatus::blow_up);
}

}  // namespace scree::run
