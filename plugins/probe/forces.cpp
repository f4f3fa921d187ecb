// How contact forces are distributed.

#include <algorithm>
#include <cmath>
#include <iterator>

#include <scree/plugin/contact_line.hpp>
#include <scree/plugin/space_bins.hpp>

namespace {

struct ForcesProbe {
  scree::SpaceBins region;
  bool walls = false;
  int classes = 24;
  double largest = 6;

  static constexpr scree::About about = {
      "forces", "distribution of normal and tangential contact forces, their moments, mobilised friction",
      "normal_<k>: P of f = f_n/⟨f_n⟩ in class k: (k − 1) w ≤ f < k w, w = largest/classes; ∫ P df = 1 over all f\n"
      "tangential_<k>: likewise of |f_t|/⟨|f_t|⟩;   *_moment_<n> = ⟨f^n⟩/⟨f⟩^n\n"
      "mobilised = |f_t|/f_n of repulsive contacts; NaN without contacts",
      "Radjai et al. 1996"};

  void declare(scree::Declaration& d) {
    region.declare_region(d);
    d.boolean("walls", walls, "contacts with walls count too");
    d.integer("classes", classes, "", scree::Range{.minimum = 1, .maximum = 1000}, "of P(f)");
    d.number("largest", largest, "", scree::positive, "force at the end of the last class, over the mean");
  }
  void prepare(const scree::Setup& setup) { region.check(setup); }
  void describe(scree_probe_instance& instance) const {
    instance.needs = SCREE_NEEDS_CONTACTS;
    instance.column_count = std::size(names) + 2 * std::uint32_t(classes);
    instance.leaves_out = 1;
    instance.total_count = region.totals() + sum_count + 2 * per_component() + 1;
    instance.largest_count = 1;
    instance.passes = region.passes() + 2;
  }
  scree::ColumnName column(std::uint32_t c) const {
    if (c < std::size(names)) return {names[c], units[c], meanings[c]};
    const std::uint32_t k = c - std::uint32_t(std::size(names)), n = std::uint32_t(classes);
    return {std::string(k < n ? "normal_" : "tangential_") + std::to_string(k % n + 1), "",
            "probability density of the force over its mean"};
  }
  std::string start(const scree_view& view, double*) const { return region.problem(view); }

  void accumulate(const scree_view& part, std::uint32_t pass, double* totals) const {
    if (region.finds_followed(part, pass, totals)) return;
    const scree::AveragingFrame frame = region.frame(part);
    const double* const before = part.totals + region.totals();
    for (std::uint64_t c = 0; c < part.contact_count; ++c) {
      if (!scree::counts_contact(part, c) || (!walls && part.contact_b[c] >= part.body_count)) continue;
      const scree::ContactLine line(part, c);
      if (frame.bin_of(line.point()) < 0) continue;
      const double f_n = dot(line.force, line.normal);
      const double f_t = norm(line.force - f_n * line.normal);
      if (pass == region.passes()) {
        add_to_means(f_n, f_t, totals);
      } else {
        add_to_distribution(f_n / (before[normal] / before[contacts]), distribution(totals, 0));
        add_to_distribution(f_t / (before[tangential] / before[contacts]), distribution(totals, 1));
      }
    }
  }

  void sample(const scree_view& view, const double*, double* row) const {
    const double* const sums = view.totals + region.totals();
    const double n = sums[contacts], largest_mobilised = distribution(view.totals, 2)[0];
    *row++ = n;
    *row++ = sums[normal] / n;
    *row++ = sums[tangential] / n;
    for (const std::uint32_t component : {0u, 1u})
      for (std::uint32_t k = 0; k < moments; ++k) *row++ = distribution(view.totals, component)[k] / n;
    *row++ = sums[mobilised] / sums[repulsive];
    *row++ = sums[repulsive] > 0 ? largest_mobilised : std::nan("");
    for (const std::uint32_t component : {0u, 1u})
      for (int k = 0; k < classes; ++k)
        *row++ = distribution(view.totals, component)[moments + std::uint32_t(k)] / (n * largest / classes);
  }

 private:
  // Totals, after the position of a followed body: the sums of `Sum`; for normal, then for tangential forces
  // over their mean, sums of powers 2, 3 and 4, then numbers in classes; the largest mobilised friction.
  enum Sum : std::uint32_t { contacts, normal, tangential, repulsive, mobilised, sum_count };
  static constexpr std::uint32_t moments = 3;
  std::uint32_t per_component() const { return moments + std::uint32_t(classes); }
  template <class Number>
  Number* distribution(Number* totals, std::uint32_t component) const {
    return totals + region.totals() + sum_count + component * per_component();
  }
  void add_to_means(double f_n, double f_t, double* totals) const {
    double* const sums = totals + region.totals();
    double& largest_mobilised = distribution(totals, 2)[0];
    sums[contacts] += 1;
    sums[normal] += f_n;
    sums[tangential] += f_t;
    if (!(f_n > 0)) return;
    sums[repulsive] += 1;
    sums[mobilised] += f_t / f_n;
    largest_mobilised = std::max(largest_mobilised, f_t / f_n);
  }
  void add_to_distribution(double f, double* sums) const {
    for (std::uint32_t k = 0; k < moments; ++k) sums[k] += std::pow(f, k + 2);
    if (const double k = std::floor(f / (largest / classes)); k >= 0 && k < classes)
      sums[moments + std::uint32_t(k)] += 1;
  }

  static constexpr const char* names[] = {"contacts",
                                          "normal_mean",
                                          "tangential_mean",
                                          "normal_moment_2",
                                          "normal_moment_3",
                                          "normal_moment_4",
                                          "tangential_moment_2",
                                          "tangential_moment_3",
                                          "tangential_moment_4",
                                          "mobilised_mean",
                                          "mobilised_largest"};
  static constexpr const char* units[] = {"", "N", "N", "", "", "", "", "", "", "", ""};
  static constexpr const char* meanings[] = {"number of contacts",
                                             "mean normal force, above 0 if repulsive",
                                             "mean magnitude of the tangential force",
                                             "mean of the n-th power over the n-th power of the mean",
                                             "mean of the n-th power over the n-th power of the mean",
                                             "mean of the n-th power over the n-th power of the mean",
                                             "mean of the n-th power over the n-th power of the mean",
                                             "mean of the n-th power over the n-th power of the mean",
                                             "mean of the n-th power over the n-th power of the mean",
                                             "mean of tangential over normal force",
                                             "largest tangential over normal force"};
};

}  // namespace

SCREE_PROBE_PLUGIN(ForcesProbe)
