#pragma once

#include "report_support.hpp"
#include "results.hpp"

namespace scree::test {

// Two values of friction and two cases, with two seeds each; one run has failed.
inline void write_campaign(const TemporaryFolder& folder) {
  std::string runs,
      rows =
          "run,case,contact.friction,seed,status,expectations,expectations_met,warnings,e.work.last,wall_s\n";
  int number = 0;
  for (const char* one : {"soft", "hard"})
    for (const char* friction : {"0.1", "0.4"})
      for (int seed = 1; seed <= 2; ++seed, ++number) {
        const std::string name = std::string(one) + ",friction=" + friction + ",seed=" + std::to_string(seed);
        const bool failed = number == 7;
        runs += (number ? ", " : "") +
                ("{\"run\": \"" + name + "\", \"status\": \"" + (failed ? "failed" : "finished") + "\"" +
                 (failed ? ", \"error\": \"it <blew> up\"" : "") + "}");
        rows += "\"" + name + "\"," + one + "," + friction + "," + std::to_string(seed) +
                (failed ? ",failed,,,,,\n"
                        : ",finished,1,1,," + std::to_string(0.001 * (number + 2 * seed)) + ",2.5\n");
      }
  folder.write("campaign.json",
               R"({"version": "1", "title": "Friction", "file": "/a/friction.toml", "scenario": "fall.toml",
    "seeds": [1, 2], "collect": ["e.work.last"], "fixed": {"snapshot": {}}, "runs": [)" +
                   runs + "]}");
  folder.write("table.csv", rows);
  write(folder, "soft,friction=0.1,seed=1/series/e.csv", "time [s],work [J]\n0,1\n");
  write(folder, "soft,friction=0.1,seed=1/report.html", "");
}

inline report::Results campaign_of(const TemporaryFolder& folder) {
  return {folder.path(), report::Json::parse(text_of(folder / "campaign.json")), "campaign", "campaign"};
}

}  // namespace scree::test
