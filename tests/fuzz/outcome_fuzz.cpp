#include "support.hpp"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <scree/campaign/outcome.hpp>

// run.json and a time series of a run, separated by a byte 0, as a campaign reads them. Damaged ones count as
// missing or as failed.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path run =
      std::filesystem::temp_directory_path() / ("scree_fuzz_run_" + std::to_string(getpid()));
  std::filesystem::create_directories(run / "series");
  const std::string_view text = scree::fuzz::text_of(data, size);
  const std::size_t end = std::min(text.find('\0'), text.size());
  std::ofstream(run / "run.json", std::ios::binary) << text.substr(0, end);
  std::ofstream(run / "series" / "energy.csv", std::ios::binary)
      << text.substr(std::min(end + 1, text.size()));
  return scree::fuzz::accept_or_refuse([&] {
    scree::campaign::Campaign campaign;
    campaign.collect = {"energy.work.last", "energy.residual.max"};
    scree::campaign::read_outcome(run, campaign, {}).unmet();
  });
}
