#include "support/resume_arguments.hpp"

namespace scree::tool {

Verb add_resume_options(CommandLine& line, ResumeArguments& arguments) {
  Verb verb = line.verb(
      "resume",
      "Go on with a run, a spectrum or a quasi-static load from its latest state, to the same bits");
  verb.option("directory", arguments.directory, "Directory of the run, spectrum or quasi-static load")
      .required();
  verb.option("--until", arguments.until,
              "Time (s) at which the last stage is to end; prolongs a finished run")
      .above_zero()
      .shown_as("SECONDS");
  verb.option("--from", arguments.from, "Go back to the end of this stage; needs --overwrite")
      .shown_as("STAGE");
  verb.flag("--overwrite", arguments.overwrite,
            "Replace results: those after --from, or all of a run that has no state yet");
  verb.option("--set", arguments.overrides,
              "Change how long a stage lasts, for example --set stage.cycle.duration=5")
      .shown_as("KEY=VALUE");
  verb.option("--threads", arguments.threads,
              "Number of threads; results are bitwise identical for any number (default 1)")
      .between(1, 1024);
  add_checkpoint_option(verb, arguments.checkpoint_every);
  verb.flag("--quiet", arguments.quiet,
            "Print only warnings, unmet expectations and the location of the results");
  add_plugin_options(verb, arguments.plugins);
  verb.footer("Example: scree resume runs/first --until 0.5");
  return verb;
}

}  // namespace scree::tool
