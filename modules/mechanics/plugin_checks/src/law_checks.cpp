#include "law_under_check.hpp"

#include <functional>

#include <fmt/format.h>

#include <scree/child_process.hpp>
#include <scree/error.hpp>

namespace scree::plugin_checks {

namespace {

using Verdict = Check::Verdict;

// Checks as they are sent from one process to another.
std::string packed(const Checks& checks) {
  std::string bytes;
  for (const Check& check : checks) {
    bytes += char(check.verdict);
    for (const std::string& text : {check.name, check.detail}) bytes.append(text.c_str(), text.size() + 1);
  }
  return bytes;
}

Checks unpacked(const std::string& bytes) {
  Checks checks;
  for (std::size_t at = 0; at < bytes.size();) {
    Check check{.name = "", .verdict = Verdict(bytes[at++]), .detail = ""};
    for (std::string* text : {&check.name, &check.detail}) {
      *text = bytes.c_str() + at;
      at += text->size() + 1;
    }
    checks.push_back(check);
  }
  return checks;
}

// Runs families of checks, each in a child process, so that there is a verdict whatever the law does.
class Families {
 public:
  explicit Families(double longest) : longest_(longest) {}

  Checks run(const std::string& name, const std::function<Checks()>& family) {
    if (held_) return {{name, Verdict::skipped, "a check before did not end"}};
    const ChildEnd end = in_child([&](const Send& send) { send(packed(family())); }, {.seconds = longest_});
    if (end.how == ChildEnd::returned) return unpacked(end.sent);
    held_ = end.how == ChildEnd::out_of_time;
    const bool ends = end.how == ChildEnd::exited || end.how == ChildEnd::signalled;
    return {{name, Verdict::failed,
             ends ? fmt::format("the law ends the program ({})", end.text()) : end.text()}};
  }

 private:
  double longest_;  // (s)
  bool held_ = false;
};

void append(Checks& all, const Checks& more, int dimension) {
  for (Check check : more) {
    check.name += fmt::format(", {}D", dimension);
    all.push_back(check);
  }
}

// A check that has failed if the closed forms cannot be used. Throws Error if the parameters are refused.
Checks check_closed_forms(const Parameters& law, const CheckedPair& pair, Families& families) {
  const std::string name = "closed forms are usable", refused = "the parameters are refused";
  const Checks found = families.run(name, [&]() -> Checks {
    try {
      for (const int dimension : dimensions_of(law)) {
        const ConfiguredLaw configured(law, dimension, no_bounds, no_bounds);
        try {
          contact_time_of(configured, pair, dimension);
        } catch (const Error& error) {
          return {{name, Verdict::failed, error.what()}};
        }
      }
    } catch (const Error& error) {
      return {{refused, Verdict::failed, error.what()}};
    }
    return {};
  });
  if (!found.empty() && found.front().name == refused) throw Error(found.front().detail);
  return found;
}

// The families of one dimension.
Checks check_in(int dimension, const Parameters& law, const std::filesystem::path& library,
                const CheckedPair& pair, Families& families) {
  using CheckBatches = Checks (*)(const LawUnderCheck&);
  const auto in_batches = [&](CheckBatches check) -> Checks {
    const ConfiguredLaw configured(law, dimension, no_bounds, no_bounds);
    const double time = contact_time_of(configured, pair, dimension);
    return check(
        {configured, dimension, Passage(dimension, pair, time > 0 ? time : 1e-3 * pair.radius / pair.speed)});
  };
  Checks all;
  const auto add = [&](const char* name, const std::function<Checks()>& family) {
    for (const Check& check : families.run(name, family)) all.push_back(check);
  };
  add("symmetries", [&] { return in_batches(check_symmetries); });
  add("direction of the force", [&] { return in_batches(check_direction); });
  add("parting", [&] { return in_batches(check_parting); });
  add("batches of any size", [&] { return in_batches(check_batches); });
  add("instruction levels", [&] { return check_levels(law, library, pair, dimension); });
  add("derivatives", [&] { return in_batches(check_derivatives); });
  add("limits of the parameters", [&] { return check_limits(law, pair, dimension); });
  add("impacts", [&] { return check_impacts(law, pair, dimension); });
  return all;
}

}  // namespace

Checks check_law(const Parameters& law, const std::filesystem::path& library, const CheckedPair& pair,
                 double longest) {
  Families families(longest);
  if (const Checks unusable = check_closed_forms(law, pair, families); !unusable.empty()) return unusable;
  Checks all;
  for (const int dimension : dimensions_of(law))
    append(all, check_in(dimension, law, library, pair, families), dimension);
  for (const Check& check : check_machine_code(library)) all.push_back(check);
  return all;
}

}  // namespace scree::plugin_checks
