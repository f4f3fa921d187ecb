#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <scree/campaign/campaign.hpp>

namespace scree::campaign {

// Status of the run of a point.
enum class Status {
  missing,
  changed,      // run with other settings, or another scenario, file of bodies or plug-in
  interrupted,  // stopped or killed before its end
  running,
  failed,
  finished,
  queued  // waits in the queue of a batch system; only in lists
};
const char* status_name(Status status);

struct Outcome {
  Status status = Status::missing;
  std::string problem;  // one line, if the run failed or its record cannot be read
  // Of a finished run, by name: collected quantities, numbers of run.json, values of its expectations.
  std::vector<std::pair<std::string, double>> numbers;
  struct Judged {
    std::string requirement;
    bool met = false;
  };
  std::vector<Judged> expectations;
  std::vector<std::string> warnings = {};  // of a finished run
  bool blew_up = false;                    // a failed run

  // A number of a finished run; NaN if it has none of this name.
  double number(const std::string& name) const;
  std::size_t unmet() const;
};

// Reads the record of a run or spectrum, and the collected quantities, from its directory. An unreadable or
// invalid file counts as missing.
Outcome read_outcome(const std::filesystem::path& directory, const Campaign& campaign, const Inputs& inputs);

}  // namespace scree::campaign
