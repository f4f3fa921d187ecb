// How contact forces are distributed.

#include <algorithm>
#include <cmath>
#include <vector>

#include <scree/plugin/contact_line.hpp>
#include <scree/plugin/space_bins.hpp>

namespace {

// One component of the forces: its mean, powers over the mean, and P(f).
struct Distribution {
  std::vector<double> values;

  double mean() const { return moment(1, 1); }
  // ⟨f^n⟩/⟨f⟩^n, with the mean given.
  double moment(int power, double mean) const {
    double sum = 0;
    for (const double f : values) sum += std::pow(f / mean, power);
    return sum / double(values.size());
  }
  // Writes the probability densities of f/⟨f⟩ in classes from 0 to `largest`, and returns the end.
  double* write_classes(double mean, int classes, double largest, double* row) const {
    std::vector<double> counts(std::size_t(classes), 0);
    const double width = largest / classes;
    for (const double f : values)
      if (const double k = std::floor(f / mean / width); k >= 0 && k < classes) counts[std::size_t(k)] += 1;
    for (const double count : counts) *row++ = count / (double(values.size()) * width);
    return row;
  }
};

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
  }
  scree::ColumnName column(std::uint32_t c) const {
    if (c < std::size(names)) return {names[c], units[c], meanings[c]};
    const std::uint32_t k = c - std::uint32_t(std::size(names)), n = std::uint32_t(classes);
    return {std::string(k < n ? "normal_" : "tangential_") + std::to_string(k % n + 1), "",
            "probability density of the force over its mean"};
  }
  std::string start(const scree_view& view, double*) const { return region.problem(view); }

  void sample(const scree_view& view, const double*, double* row) const {
    const scree::AveragingFrame frame = region.frame(view);
    Distribution normal, tangential, mobilised;
    for (std::uint64_t c = 0; c < view.contact_count; ++c) {
      if (!scree::counts_contact(view, c) || (!walls && view.contact_b[c] >= view.body_count)) continue;
      const scree::ContactLine line(view, c);
      if (frame.bin_of(line.point()) < 0) continue;
      const double f_n = dot(line.force, line.normal);
      const double f_t = norm(line.force - f_n * line.normal);
      normal.values.push_back(f_n);
      tangential.values.push_back(f_t);
      if (f_n > 0) mobilised.values.push_back(f_t / f_n);
    }
    const double mean_n = normal.mean(), mean_t = tangential.mean();
    *row++ = double(normal.values.size());
    *row++ = mean_n;
    *row++ = mean_t;
    for (int power = 2; power <= 4; ++power) *row++ = normal.moment(power, mean_n);
    for (int power = 2; power <= 4; ++power) *row++ = tangential.moment(power, mean_t);
    *row++ = mobilised.mean();
    *row++ = mobilised.values.empty() ? std::nan("")
                                      : *std::max_element(mobilised.values.begin(), mobilised.values.end());
    row = normal.write_classes(mean_n, classes, largest, row);
    tangential.write_classes(mean_t, classes, largest, row);
  }

 private:
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
