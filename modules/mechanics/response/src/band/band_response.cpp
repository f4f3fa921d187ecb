#include "assembly/mass_weighted.hpp"
#include "band/band_library.hpp"
#include "band/singular.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numbers>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include <scree/allowed_processors.hpp>
#include <scree/error.hpp>
#include <scree/response/band_response.hpp>
#include <scree/thread_pool.hpp>

namespace scree::response {

namespace {

// Frequencies that share a factorisation at first: up to 1.5 times the lowest, since linewidths of a packing
// grow with frequency, and within these numbers. Windows that one factorisation does not serve are divided.
constexpr std::size_t narrowest_window = 24, widest_window = 48;
constexpr double window_span = 1.5;
// Down to this tolerance iterations converge as fast with a factorisation in single precision.
constexpr double single_precision_tolerance = 1e-5;

class BandSolution {
 public:
  BandSolution(const LinearSystem& system, const Drive& drive, const std::vector<double>& frequencies_hz,
               const BandOptions& options)
      : weighted_(system),
        drive_(drive),
        options_(options),
        tolerance_(options.tolerance),
        frequencies_(frequencies_hz),
        sorted_(frequencies_hz.size()),
        mass_((system.mass.array() > 0).cast<double>()) {
    std::iota(sorted_.begin(), sorted_.end(), std::size_t(0));
    std::stable_sort(sorted_.begin(), sorted_.end(),
                     [&](std::size_t a, std::size_t b) { return frequencies_[a] < frequencies_[b]; });
    weighted_.load(drive, 0);  // refuses a drive of another size
    backend_ =
        band_library().create(view_of(weighted_.stiffness()), view_of(weighted_.damping()), mass_.data());
    result_.responses.resize(frequencies_hz.size());
  }

  // Windows are independent, so that results do not depend on the number of threads.
  BandResponse run(unsigned threads) {
    const std::vector<std::size_t> ends = window_ends();
    const std::size_t windows = ends.size();
    std::vector<char> finished(windows);
    ThreadPool pool(unsigned(std::min<std::size_t>(threads, windows)), ThreadPool::IfTooFew::use_fewer);
    pool.each_in_order(windows, [&](std::size_t w, unsigned) {
      if (!proceeds()) return;
      solve(w == 0 ? 0 : ends[w - 1], ends[w]);
      finished[w] = proceeds();
    });
    leave_out_from(ends, finished);
    std::erase_if(result_.responses, [](const HarmonicResponse& r) { return r.amplitude.size() == 0; });
    return std::move(result_);
  }

 private:
  // 0 Hz has a separate window, so that a singular stiffness is noticed.
  std::vector<std::size_t> window_ends() const {
    std::vector<std::size_t> ends;
    for (std::size_t from = 0, to = 0; from < sorted_.size(); from = to) {
      const double lowest = frequencies_[sorted_[from]];
      const std::size_t fewest = lowest > 0 ? narrowest_window : 1;
      while (to < sorted_.size() && to - from < widest_window &&
             (to - from < fewest || frequencies_[sorted_[to]] <= window_span * lowest))
        ++to;
      ends.push_back(to);
    }
    return ends;
  }
  bool proceeds() const { return !options_.stop || !*options_.stop; }

  // After a stop, drops all frequencies from the first unfinished window on: asked for later, they form the
  // same windows.
  void leave_out_from(const std::vector<std::size_t>& ends, const std::vector<char>& finished) {
    const auto first = std::size_t(std::find(finished.begin(), finished.end(), 0) - finished.begin());
    for (std::size_t k = first == 0 ? 0 : ends[first - 1]; first < ends.size() && k < sorted_.size(); ++k)
      result_.responses[sorted_[k]].amplitude.resize(0);
  }

  // Solves the sorted frequencies from `from` to `to`.
  void solve(std::size_t from, std::size_t to) {
    const std::size_t count = to - from;
    Eigen::VectorXd omega(count), residual(count), error(count);
    Eigen::MatrixXcd loads(mass_.size(), count), amplitude(mass_.size(), count);
    for (std::size_t k = 0; k < count; ++k) {
      omega[k] = 2 * std::numbers::pi * frequencies_[sorted_[from + k]];
      loads.col(k) = weighted_.load(drive_, omega[k]);
    }
    solve_window(omega, loads, amplitude, residual, error);
    if (weighted_.has_time_step()) add_time_step(omega, loads, amplitude, residual, error);
    if (!proceeds()) return;
    for (std::size_t k = 0; k < count;) {
      if (count == 1 || error[k] <= tolerance_) {
        keep(sorted_[from + k], amplitude.col(k), residual[k], error[k]);
        ++k;
        continue;
      }
      std::size_t end = k + 1;
      while (end < count && end - k < (count + 1) / 2 && !(error[end] <= tolerance_)) ++end;
      solve(from + k, from + end);
      k = end;
    }
    report_progress();
  }

  void solve_window(const Eigen::VectorXd& omega, const Eigen::MatrixXcd& loads, Eigen::MatrixXcd& amplitude,
                    Eigen::VectorXd& residual, Eigen::VectorXd& error) {
    const Eigen::VectorXd nearest = omega.unaryExpr([this](double w) { return weighted_.nearest_omega(w); });
    const int count = int(omega.size());
    const bool single = tolerance_ >= single_precision_tolerance && count > 1;
    const int basis = backend_->solve({count, nearest.data(), loads.data(), tolerance_, single,
                                       amplitude.data(), residual.data(), error.data(), options_.stop});
    if (proceeds()) count_factorisation(basis);
  }

  // The time step changes the damping by some per cent, which goes to the loads and is found by iteration.
  void add_time_step(const Eigen::VectorXd& omega, const Eigen::MatrixXcd& loads, Eigen::MatrixXcd& amplitude,
                     Eigen::VectorXd& residual, Eigen::VectorXd& error) {
    constexpr int most_passes = 20;
    constexpr double share_of_tolerance = 0.1;
    Eigen::MatrixXcd changed = loads;
    Eigen::VectorXd change(omega.size());
    for (int round = 0; round < most_passes && proceeds() && !error.hasNaN(); ++round) {
      const Eigen::MatrixXcd before = amplitude;
      for (Eigen::Index k = 0; k < omega.size(); ++k)
        changed.col(k) = loads.col(k) - weighted_.difference(omega[k], before.col(k));
      solve_window(omega, changed, amplitude, residual, error);
      for (Eigen::Index k = 0; k < omega.size(); ++k) {
        const double length = amplitude.col(k).norm();
        change[k] = length > 0 ? (amplitude.col(k) - before.col(k)).norm() / length : 0;
      }
      if (change.maxCoeff() <= share_of_tolerance * tolerance_) break;
    }
    error += change;
  }

  void count_factorisation(int basis) {
    const std::lock_guard lock(mutex_);
    ++result_.statistics.factorisations;
    result_.statistics.largest_basis = std::max(result_.statistics.largest_basis, basis);
  }

  void keep(std::size_t at, const Eigen::VectorXcd& amplitude, double residual, double error) {
    if (std::isnan(error)) throw singular_at(frequencies_[at]);
    result_.responses[at] = {frequencies_[at], weighted_.amplitude(amplitude), residual, error};
    const std::lock_guard lock(mutex_);
    ++found_;
  }

  // Reports once per window, so that the time left follows from the work of whole windows.
  void report_progress() {
    const std::lock_guard lock(mutex_);
    if (found_ == std::exchange(reported_, found_)) return;  // by a part of this window
    if (options_.on_progress) options_.on_progress(double(found_) / double(frequencies_.size()));
  }

  const MassWeighted weighted_;
  const Drive& drive_;
  const BandOptions& options_;
  double tolerance_;
  const std::vector<double>& frequencies_;
  std::vector<std::size_t> sorted_;
  Eigen::VectorXd mass_;  // in these coordinates 1 or 0
  std::unique_ptr<BandBackend> backend_;
  std::mutex mutex_;
  std::size_t found_ = 0, reported_ = 0;
  BandResponse result_;
};

}  // namespace

BandResponse solve_band(const LinearSystem& system, const Drive& drive,
                        const std::vector<double>& frequencies_hz, const BandOptions& options) {
  if (!(options.tolerance > 0))
    throw Error(fmt::format("BandOptions::tolerance is {:g}; give a number above 0", options.tolerance));
  const auto start = std::chrono::steady_clock::now();
  const unsigned threads = options.threads > 0 ? options.threads : allowed_processors();
  BandResponse result = BandSolution(system, drive, frequencies_hz, options).run(threads);
  result.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace scree::response
