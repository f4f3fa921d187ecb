#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <scree/campaign/campaign.hpp>

namespace scree::campaign {

// What the directory of a point holds.
enum class State {
  missing,
  changed,      // a run of other settings, another scenario or an older file of bodies
  interrupted,  // stopped or killed before its end
  running,
  failed,
  finished
};
const char* state_name(State state);

struct Outcome {
  State state = State::missing;
  std::string problem;  // one line, of a run that failed
  // Of a run that finished: what is collected, the numbers of run.json, those of its expectations; by name.
  std::vector<std::pair<std::string, double>> numbers;
  struct Judged {
    std::string requirement;
    bool met = false;
  };
  std::vector<Judged> expectations;

  std::size_t unmet() const;
};

// Reads the run.json of a directory, and what is collected from its series. Anything that it cannot make
// sense of counts as missing.
Outcome read_outcome(const std::filesystem::path& directory, const Inputs& inputs,
                     const std::vector<std::string>& collect);

}  // namespace scree::campaign
