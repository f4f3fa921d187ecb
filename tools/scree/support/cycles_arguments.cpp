#include "support/cycles_arguments.hpp"

namespace scree::tool {

Verb add_cycles_options(CommandLine& line, CyclesArguments& a) {
  Verb verb =
      line.verb("cycles", "Strain over the cycles of a load: ratcheting, shakedown, creep or none of them");
  verb.option("directories", a.directories, "Directories of runs; several give a table of verdicts");
  verb.option("--csv", a.csv, "Instead of runs: CSV file; its first column is the time in s")
      .shown_as("FILE");
  verb.option("--probe", a.probe, "Probe of the runs; default: the first whose series has the columns")
      .shown_as("NAME");
  verb.option(
          "--touching", a.touching,
          "Probe of the kind touching, beside the series: names rattlers and their touches before outliers")
      .shown_as("NAME");
  verb.option("--strain", a.strain,
              "Column, or lengths: length_y/length_y0 - length_x/length_x0, which is the default")
      .shown_as("NAME");
  verb.option("--load", a.load, "Column of the load, for areas and stiffnesses of the loops")
      .shown_as("NAME");
  verb.option(
          "--period", a.period,
          "Period of the load (s); default: that of the last stage that has one, else one row is one cycle")
      .above_zero()
      .shown_as("T");
  verb.option(
          "--start", a.first_minimum,
          "Time of the first minimum of the load (s); default: the beginning of that stage, or the first row")
      .finite()
      .shown_as("TIME");
  verb.option("--drop", a.drop, "Cycles before the first that counts (default 29)").between(0, 1e9);
  verb.option("--round-off", a.round_off,
              "Largest range of a constant strain, and least deviation of an outlier (default 1e-13)")
      .above_zero();
  verb.option(
          "--out", a.out,
          "Directory of the results; default that of the run or the CSV file, for several runs the current one")
      .shown_as("DIR");
  verb.flag("--overwrite", a.overwrite, "Replace results of other series and runs in the directory");
  verb.footer(
      "Ratcheting: the root mean square deviation from a straight line is below its slope per cycle (McNamara et al. 2008).\n"
      "Shakedown goes to a limit, creep does not; settling: the strain per cycle falls, and the cycles do not tell which.\n"
      "Example: scree cycles runs/biaxial\n"
      "         scree cycles campaigns/laws/*/ --out campaigns/laws\n"
      "         scree cycles --csv box.csv --strain deviatoric_strain --load deviatoric_stress --period 10 --drop 5");
  return verb;
}

}  // namespace scree::tool
