#include "support.hpp"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <scree/report/page.hpp>

// A record and a table of results, separated by a byte 0, as `scree report` reads them: of each kind of
// results in turn, by the length of the input.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr const char* records[] = {"run.json",      "campaign.json", "spectrum.json",
                                            "accuracy.json", "modes.json",    "quasi_static.json"};
  static const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("scree_fuzz_report_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder / "series");
  const std::string_view text = scree::fuzz::text_of(data, size);
  const std::size_t end = std::min(text.find('\0'), text.size());
  const char* const record = records[size % std::size(records)];
  for (const char* name : {record, "cycles.json"})
    std::ofstream(folder / name, std::ios::binary) << text.substr(0, end);
  for (const char* table : {"series/energy.csv", "table.csv", "spectrum.csv", "peaks.csv", "accuracy.csv",
                            "modes.csv", "final_packing.csv", "verdicts.csv", "cycles.csv"})
    std::ofstream(folder / table, std::ios::binary) << text.substr(std::min(end + 1, text.size()));
  const int result = scree::fuzz::accept_or_refuse([&] { scree::report::page_of(folder); });
  std::filesystem::remove(folder / record);
  return result;
}
