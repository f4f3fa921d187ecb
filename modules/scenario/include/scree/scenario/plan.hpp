#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <scree/branching.hpp>
#include <scree/document/document.hpp>
#include <scree/fields/grid_request.hpp>
#include <scree/pictures/render_options.hpp>
#include <scree/plugin_host.hpp>
#include <scree/probes.hpp>
#include <scree/scenario/input_files.hpp>
#include <scree/scenario/study_table.hpp>
#include <scree/scene.hpp>
#include <scree/scene_record.hpp>
#include <scree/stage.hpp>

namespace scree::scenario {

// Consecutive ids of bodies, both ends included.
struct IdRange {
  std::int64_t first, last;
};

// The bodies of one [[particles]] or [[particle]]; those of [[particle]] without a name are one source.
struct BodySource {
  std::string name;          // as given, or "particles", "particles_2", "particle"
  std::string origin;        // "of a lattice, simple_cubic"; empty for single bodies
  std::vector<IdRange> ids;  // ascending
  std::size_t count() const;
  // "bed: 7 bodies of a lattice, simple_cubic; ids 1 to 7"
  std::string text() const;
};

// A column of another probe that a probe reads.
struct ProbeInput {
  std::size_t probe, column;  // in Plan::probes, and in the rows of that probe
};

// A probe that writes series/<name>.csv.
struct ProbePlan {
  std::string name;
  Parameters parameters;
  double every = 0;                          // (s) between samples, rounded to whole steps when it runs
  std::optional<double> observe_every = {};  // (s) likewise, between observations; absent: every step
  std::vector<ProbeInput> inputs = {};       // as the plug-in numbers them
  std::size_t depth = 0;                     // greater than the depth of each probe of its inputs
  std::vector<std::uint8_t> left_out = {};   // 1 for bodies that it does not count; empty: it counts all
  std::vector<std::string> stages;           // stages in which it records; all if empty
  std::string place;                         // file:line:column, for messages
  // Of [derived], for each column: stages in which it has values, NaN in others; all if empty.
  std::vector<std::vector<std::string>> stages_of_columns = {};

  const std::vector<std::string>& stages_of(std::size_t column) const {
    return stages_of_columns.empty() ? stages : stages_of_columns[column];
  }
};

// The probe that a plan describes.
Probe configured(const ProbePlan& probe, int dimension);

// Intervals between files and images of the whole scene; absent: none are written.
struct SnapshotPlan {
  std::optional<double> every;        // (s) between .vtp files
  std::optional<double> image_every;  // (s) between images
  bool sliding_work = false;          // on facets of surfaces, in .vtp files
  bool h5md = false;                  // the same frames in trajectory.h5md
  std::optional<int> film_rate;       // (Hz) of a film of the images; absent: none is made
  pictures::RenderOptions picture;    // color_range absent: of all pictures so far
  bool any() const { return every || image_every; }
};

// Fields on a grid, of a [[fields]].
struct FieldsPlan {
  std::string name;
  double every = 0;                 // (s) rounded to whole steps when it runs
  bool table = false;               // <name>.csv instead of <name>_<step>.vti
  std::vector<std::string> stages;  // in which it is computed; all if empty
  fields::GridRequest request;
  std::string place;  // file:line:column of the table, for messages

  bool is_of(const std::string& stage) const {
    return stages.empty() || std::find(stages.begin(), stages.end(), stage) != stages.end();
  }
};

// When the state of a run is written.
struct CheckpointPlan {
  std::optional<double> every = 600;  // (s) of wall time; absent: never
  std::optional<double> every_time;   // (s) simulated, from t = 0
  bool final_state = true;            // at the end of the run
  bool stage_states = true;           // at the end of each stage but the last
};

// Reads a wall time: "30 s", "10 min", "2 h", or "never", which gives nothing. Throws Error without a place.
std::optional<double> parse_wall_time(const std::string& text);

// One curve of a chart, from the series of a probe.
struct CurvePlan {
  std::string name;
  std::string probe, x, y;  // columns; x may be "time"
};

// Curves over numbered columns, such as those of bins: one for each of some times.
struct ProfilePlan {
  std::string probe;
  std::vector<std::string> columns;  // in their order
  double low = 0, high = 0;          // x at the outer ends of the first and the last column
  int curves = 1;                    // at equal numbers of samples apart, the last at the end
};

struct ChartPlan {
  std::string name;    // of the file
  std::string format;  // one of charts::chart_formats
  std::string title, x_label, y_label;
  std::string x_unit, y_unit;  // SI, shown with a prefix after the label; empty: none is added
  std::vector<CurvePlan> curves;
  std::optional<ProfilePlan> profile;  // instead of curves
  bool log_x = false, log_y = false;

  std::string file_name() const { return name + "." + format; }
};

// A required result of a run or a study.
struct Expectation {
  std::string requirement;  // text for people
  std::string quantity;     // "energy_residual", "<probe>.<column>.<last|...|mean>", or of a study
  std::optional<double> reference, tolerance;
  std::optional<double> at_most, at_least;
  bool of_step = false;         // the reference is valid only for the time step in the file
  std::optional<double> scale;  // divisor for relative errors; |reference| if absent
  std::string place = {};       // file:line:column, for messages
};

// Largest number of steps of a stage, or of one frequency of a sweep. At one microsecond per step, faster
// than almost any scene, this takes twelve days.
inline constexpr double most_steps = 1e12;

// A scenario file, read and checked. The PluginHost it was read with must outlive it.
struct Plan {
  std::string title;  // as given; empty: none
  std::filesystem::path source;
  std::vector<std::filesystem::path> inputs;  // files that were read: the source and packings
  InputFiles files;                           // of a run that goes on: the plug-ins
  std::uint64_t seed = 1;
  Scene scene;
  std::vector<BodySource> body_sources;     // in the order of the tables; empty for a run that goes on
  std::shared_ptr<const State> from_state;  // in which the bodies were; null for a new packing
  Branching branching;                      // what is taken over from it
  std::vector<Stage> stages;
  std::vector<ProbePlan> probes;
  SnapshotPlan snapshot;
  std::vector<FieldsPlan> fields;
  CheckpointPlan checkpoint;
  std::vector<ChartPlan> charts;
  std::vector<Expectation> expectations;        // of a run
  std::vector<Expectation> study_expectations;  // of the studies whose tables the scenario has
  std::vector<std::string> studies;             // names of these tables; with one there may be no stages
  std::optional<document::Document> document;   // from which studies read their tables; set by read_plan
  std::string resolved_text;                    // TOML with overrides
  // The same with absolute paths of packings; empty if it is not to be written.
  std::string text_for_any_folder;
  std::string bodies_place;    // file:line:column, for messages
  std::string periodic_place;  // of the first periodic boundary; empty without one
  std::string step_place;
  bool step_guard = true;             // refuse a time step that is too long
  std::vector<std::string> warnings;  // "<what>; <cure>" of what was read

  // The heading of reports: the title, or else the name of the file.
  std::string heading() const { return title.empty() ? source.stem().string() : title; }
};

// Names of all quantities for expectations: the numbers of run.json, and "<probe>.<column>.<statistic>".
std::vector<std::string> quantity_names(const std::vector<ProbePlan>& probes, int dimension);
// Returns "no quantity '<name>'; <cure>" unless the name is among `known`.
std::optional<std::string> quantity_problem(const std::string& name, const std::vector<std::string>& known);

// Reads a scenario file; `studies` check their tables. Throws Error "file:line:column: what is wrong; what to
// do" for any error in it, and for keys that nothing reads.
Plan read_plan(const std::filesystem::path& path, const std::vector<std::string>& overrides, PluginHost& host,
               const StudyTables& studies = {});

// Reads the scenario of a run that goes on: its text, as in Plan::resolved_text, and the bodies at its start
// with their groups, so that no packing is read again. name: of the text in messages. Tables of studies are
// not checked again.
Plan read_plan_again(const std::string& text, const std::string& name,
                     const std::vector<std::string>& overrides, RecordedBodies recorded, PluginHost& host);

// Refuses the keys of a scenario that nothing reads, while the state from which it begins does not exist yet:
// `bodies` are used instead of the bodies of the state, and keys of [particles] are not checked. Other errors
// are left to read_plan.
void check_keys(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                std::vector<Body> bodies, PluginHost& host, const StudyTables& studies = {});

// The override "stage[1].duration=2" that gives the last stage of a scenario, which ends by its duration or
// after cycles, this length (s).
std::string length_override(const std::string& resolved_text, double seconds);

}  // namespace scree::scenario
