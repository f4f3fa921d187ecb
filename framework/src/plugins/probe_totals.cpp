#include "plugins/guarded_numbers.hpp"
#include "plugins/plugin_call.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/probes.hpp>

// Numbers that a probe adds up over the parts of a scene.
namespace scree {

void Probe::check_totals() const {
  const scree_probe& interface = plugin_.interface();
  const scree_probe_instance& instance = plugin_.instance();
  const auto refuse = [&](const char* problem) {
    throw Error(fmt::format("plug-in {}: {}", plugin_.parameters().plugin().name, problem));
  };
  const bool accumulates = interface.struct_size > offsetof(scree_probe, accumulate) && interface.accumulate;
  if (has_totals() && !accumulates) refuse("has totals but no accumulate function; give it one");
  if (!has_totals() && (accumulates || (instance.needs & SCREE_NEEDS_CONTACT_COUNTS)))
    refuse("has an accumulate function, or needs contact counts, but no totals; set total_count");
  if (!has_totals()) return;
  // Each has an exact sum of 600 bytes in each thread, and in each message.
  constexpr std::uint32_t most_totals = 100'000, most_passes = 100;
  if (instance.total_count > most_totals || instance.passes > most_passes)
    refuse("has more than 100000 totals or 100 passes; take fewer");
  if (instance.passes == 0 || instance.largest_count > instance.total_count)
    refuse("has totals without a pass, or more largest values than totals; set passes and largest_count");
  if (observes() || !plugin_.parameters().inputs().empty())
    refuse("has totals, and observes or reads columns of other probes; leave out one of the two");
}

std::uint32_t Probe::view_needs() const {
  if (!has_totals()) return needs();
  const std::uint32_t of_start = needs() & ~std::uint32_t(SCREE_NEEDS_CONTACTS);
  return is_started_ ? of_start | SCREE_NEEDS_NO_BODIES : of_start;
}

std::vector<double> Probe::totals(const OfPass& of_pass) const {
  const std::size_t sums = first_largest();
  std::vector<double> all(sums, 0.0);
  all.resize(plugin_.instance().total_count, -std::numeric_limits<double>::infinity());
  for (std::uint32_t pass = 0; pass < plugin_.instance().passes; ++pass) {
    const std::vector<double> more = of_pass(pass, all);
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k] = k < sums ? all[k] + more[k] : std::max(all[k], more[k]);
  }
  return all;
}

std::vector<double> Probe::totals_of_part(const scree_view& part, std::uint32_t pass) const {
  const scree_probe& interface = plugin_.interface();
  const char* const name = plugin_.parameters().plugin().name;
  std::vector<double> totals = guarded(plugin_.instance().total_count);
  const auto largest = totals.begin() + std::ptrdiff_t(first_largest()), end = totals.end() - guard_size;
  std::fill(largest, end, -std::numeric_limits<double>::infinity());
  plugin_call(name, "accumulate",
              [&] { interface.accumulate(plugin_.storage(), &part, pass, totals.data()); });
  check_guard(totals, name, "totals");
  if (std::any_of(largest, end, [](double x) { return std::isnan(x); }))
    throw Error(
        fmt::format("plug-in {}: a largest value of its totals is not a number; leave NaN out", name));
  totals.resize(totals.size() - guard_size);
  return totals;
}

std::vector<double> Probe::totals_in(const scree_view& view) const {
  scree_view part = view;
  part.part_begin = 0;
  part.part_end = view.body_count;
  if (!left_out_.empty()) part.left_out = left_out_.data();
  std::vector<std::uint32_t> contacts(view.body_count, 0);
  for (std::uint64_t c = 0; c < view.contact_count; ++c)
    for (const std::uint32_t body : {view.contact_a[c], view.contact_b[c]})
      if (body < view.body_count) ++contacts[body];
  part.contacts_of_body = contacts.data();
  return totals([&](std::uint32_t pass, const std::vector<double>& before) {
    part.totals = before.data();
    return totals_of_part(part, pass);
  });
}

}  // namespace scree
