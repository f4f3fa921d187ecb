#include "band_library.hpp"
#include "mass_weighted.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numbers>
#include <numeric>
#include <thread>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/response/band_response.hpp>

namespace scree::response {

namespace {

// Frequencies that share a factorisation at first. Those that it does not serve are divided again.
constexpr std::size_t first_window = 6;
// Single precision of a factorisation makes iterations converge as fast down to such tolerances.
constexpr double single_precision_tolerance = 1e-5;

class BandSolution {
 public:
  BandSolution(const LinearSystem& system, const Drive& drive, const std::vector<double>& frequencies_hz,
               const BandOptions& options)
      : weighted_(system),
        drive_(drive),
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
    const std::size_t windows = (sorted_.size() + first_window - 1) / first_window;
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
      for (std::size_t w; (w = next++) < windows;) try {
          solve(w * first_window, std::min(sorted_.size(), (w + 1) * first_window));
        } catch (...) {
          const std::lock_guard lock(mutex_);
          if (!failure_) failure_ = std::current_exception();
          next = windows;
        }
    };
    std::vector<std::thread> others;
    for (std::size_t t = 1; t < std::min<std::size_t>(threads, windows); ++t) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
    if (failure_) std::rethrow_exception(failure_);
    return std::move(result_);
  }

 private:
  // Solves the sorted frequencies from `from` to `to`.
  void solve(std::size_t from, std::size_t to) {
    const std::size_t count = to - from;
    Eigen::VectorXd omega(count), residual(count), error(count);
    Eigen::MatrixXcd loads(mass_.size(), count), amplitude(mass_.size(), count);
    for (std::size_t k = 0; k < count; ++k) {
      omega[k] = 2 * std::numbers::pi * frequencies_[sorted_[from + k]];
      loads.col(k) = weighted_.load(drive_, omega[k]);
    }
    const bool single = tolerance_ >= single_precision_tolerance && count > 1;
    const int basis = backend_->solve({int(count), omega.data(), loads.data(), tolerance_, single,
                                       amplitude.data(), residual.data(), error.data()});
    count_factorisation(basis);
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
  }

  void count_factorisation(int basis) {
    const std::lock_guard lock(mutex_);
    ++result_.statistics.factorisations;
    result_.statistics.largest_basis = std::max(result_.statistics.largest_basis, basis);
  }

  void keep(std::size_t at, const Eigen::VectorXcd& amplitude, double residual, double error) {
    if (std::isnan(error))
      throw Error(
          fmt::format("the response at {:g} Hz is infinite: an undamped mode has this frequency; add "
                      "damping or take another frequency",
                      frequencies_[at]));
    result_.responses[at] = {frequencies_[at], weighted_.amplitude(amplitude), residual, error};
  }

  const MassWeighted weighted_;
  const Drive& drive_;
  double tolerance_;
  const std::vector<double>& frequencies_;
  std::vector<std::size_t> sorted_;
  Eigen::VectorXd mass_;  // in these coordinates 1, or 0
  std::unique_ptr<BandBackend> backend_;
  std::mutex mutex_;
  std::exception_ptr failure_;
  BandResponse result_;
};

}  // namespace

BandResponse solve_band(const LinearSystem& system, const Drive& drive,
                        const std::vector<double>& frequencies_hz, const BandOptions& options) {
  if (!(options.tolerance > 0))
    throw Error(fmt::format("BandOptions::tolerance is {:g}; give a number above 0", options.tolerance));
  const auto start = std::chrono::steady_clock::now();
  const unsigned threads =
      options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  BandResponse result = BandSolution(system, drive, frequencies_hz, options).run(threads);
  result.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace scree::response
