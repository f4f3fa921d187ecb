#include "support.hpp"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <scree/signals/amplitude_spectrum.hpp>
#include <scree/signals/lock_in.hpp>
#include <scree/signals/time_series.hpp>

// A time series as `scree spectrum` reads it, and its lines. The column is x.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("scree_fuzz_series_" + std::to_string(getpid()) + ".csv");
  std::ofstream(file, std::ios::binary) << scree::fuzz::text_of(data, size);
  return scree::fuzz::accept_or_refuse([&] {
    using namespace scree;
    using namespace scree::signals;
    const TimeSeries series = read_time_series(file, "x", 8);
    const AmplitudeSpectrum spectrum =
        amplitude_spectrum(series.mean_step(), at_equal_steps(series.times, series.values));
    strongest_lines(series.times, series.values, spectrum, 3);
    LockInOptions options;
    options.frequency = 3 / series.duration();
    lock_in(series.times, series.values, options, Detrending::period_average);
  });
}
