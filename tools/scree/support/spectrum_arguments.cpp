#include "support/spectrum_arguments.hpp"

namespace scree::tool {

Verb add_spectrum_options(CommandLine& line, SpectrumArguments& a) {
  Verb verb = line.verb(
      "spectrum", "Response of a packing to a driven wall over frequency; or the lines of a time series");
  verb.option("scenario", a.scenario, "Scenario file (TOML) with [spectrum]");
  verb.option(
          "--by", a.by,
          "Method: a sweep, a pulse, linear response of the contact network, or all of them (default sweep)")
      .one_of({"sweep", "pulse", "linear", "all"});
  verb.option("--set", a.overrides, "Change a value of the scenario").shown_as("KEY=VALUE");
  verb.option("--threads", a.threads,
              "Number of threads; results are bitwise identical for any number (default 1)")
      .between(1, 1024);
  verb.flag("--overwrite", a.overwrite,
            "Replace an existing spectrum in the directory, or files there that are not of the CSV file");
  verb.flag("--resume", a.resume, "Go on with the interrupted spectrum in --out, to the same bits");
  verb.flag("--quiet", a.quiet, "Print only warnings and the location of the results");
  verb.option("--csv", a.csv, "Instead of a scenario: CSV file; its first column is the time in s")
      .shown_as("FILE");
  verb.option("--column", a.column, "Column of the CSV file, with or without its unit").shown_as("NAME");
  verb.option("--frequency", a.frequency,
              "Fit a sine of this frequency and its harmonics; default: the strongest lines")
      .above_zero()
      .shown_as("HZ");
  verb.option(
          "--detrend", a.detrend,
          "What is removed with the fit at --frequency: a polynomial, or the mean over one period (default "
          "linear)")
      .one_of(detrendings);
  verb.option("--out", a.out,
              "Directory of the results; default runs/<scenario>-spectrum, or that of the CSV file")
      .shown_as("DIR");
  add_plugin_options(verb, a.plugins);
  verb.footer(
      "Phases are of sines; in a time series they refer to t = 0, in a response to the drive. Errors are standard errors from\n"
      "the noise near each line; without --frequency, that of a phase contains that of the frequency up to t = 0.\n"
      "Example: scree spectrum scenarios/sound/chain.toml --by all\n"
      "         scree spectrum --csv runs/quickstart/series/box.csv --column strain_xx --frequency 1");
  return verb;
}

}  // namespace scree::tool
