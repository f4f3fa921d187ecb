#include "program_verbs.hpp"

#include <memory>

#include <fmt/format.h>

#include <scree/run/charts.hpp>

namespace scree::tool {

namespace {

struct ChartArguments {
  std::string directory, scenario, out;
  std::vector<std::string> overrides;
  bool overwrite = false;
};

ExitStatus chart(const run::ChartRequest& request) {
  run::redraw_charts(request, [](const std::filesystem::path& file) { fmt::print("{}\n", file.string()); });
  return ExitStatus::success;
}

}  // namespace

void add_chart_verb(CommandLine& line) {
  Verb verb =
      line.verb("chart", "Draw the charts of a run or study again, from its tables, as PNG, SVG or PDF");
  auto a = std::make_shared<ChartArguments>();
  verb.option("directory", a->directory, "Directory of a run or of a study").required().existing_path();
  verb.option("--set", a->overrides, "Change a value of the scenario, as chart.NAME.format=svg; repeatable")
      .shown_as("KEY=VALUE");
  verb.option("--scenario", a->scenario,
              "File with [[chart]] tables; default: scenario.toml of the directory")
      .shown_as("FILE.toml");
  verb.option("--out", a->out, "Directory for the charts; default: charts/ of the run").shown_as("DIR");
  verb.flag("--overwrite", a->overwrite,
            "Replace files in --out; charts of the run are drawn again without it");
  verb.footer(
      "The probe of a [[chart]] is a series of the run, or a table of the study without its .csv.\n"
      "Example: scree chart runs/first --set chart.hysteresis.format=svg");
  verb.action([a] { return chart({a->directory, a->scenario, a->overrides, a->out, a->overwrite}); });
}

}  // namespace scree::tool
