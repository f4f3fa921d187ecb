#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <scree/modes/density.hpp>
#include <scree/modes/mode.hpp>
#include <scree/response/elastic_moduli.hpp>
#include <scree/response/load_response.hpp>
#include <scree/scenario/plan.hpp>

namespace scree::modes {

struct VibrationOptions {
  std::filesystem::path out;  // empty: runs/<stem of the scenario>-modes, numbered if it exists
  bool overwrite = false;
  unsigned threads = 1;
  unsigned modes = 20;             // that vibrate
  double near_hz = 0;              // above 0: those nearest to this frequency, else the lowest
  bool elastic = false;            // elastic constants too
  bool loads = false;              // responses to loads on walls too
  unsigned density = 0;            // frequencies at which modes are counted; 0: none
  double density_to_hz = 0;        // up to here; 0: all modes
  std::string view;                // of pictures, one of pictures::view_names; empty: iso
  std::vector<unsigned> pictures;  // numbers of modes that vibrate, from 1
  bool contacts_slide = false;     // at the limit of friction; else they stick
  int fewest_contacts = 0;         // of a body that is held; see response::AssemblyOptions
  double residual_limit = 0.01;    // above which modes are named
  std::function<void(double share, double wall_time, const std::string& what)> on_progress;
  std::function<void(const std::string&)> on_warning;  // one line "<what>; <cure>"
  const std::atomic<bool>* stop = nullptr;             // set by Ctrl-C: what is complete is saved
};

// Modes and elastic constants of a packing at rest.
struct Vibration {
  std::filesystem::path directory;
  std::string title;
  int dimension = 3;
  std::size_t bodies = 0, contacts = 0, degrees_of_freedom = 0;  // that count
  std::vector<std::int64_t> rattlers;                            // names of bodies that are left out
  double asymmetry = 0;                                          // |K − Kᵀ|/|K|
  std::size_t unstable = 0, floppy = 0;                          // modes of the packing
  bool counted = false;                                          // whether these are known
  std::vector<Mode> modes;  // unstable, floppy, vibrating ones that were found
  std::vector<Participant>
      floppy_bodies;      // kinetic energy in all floppy modes, their sum is `floppy`; from 0.01 on
  bool complete = false;  // whether counts confirm that no mode is left out
  std::optional<response::ElasticModuli> elastic;
  std::vector<response::LoadResponse> loads;
  std::vector<DensityPoint> density;
  std::vector<std::string> pictures;  // files
  std::vector<std::int64_t> names;    // of bodies, by number
  std::vector<std::string> walls;     // names
  bool interrupted = false;
  std::vector<std::string> warnings;                    // "<what>; <cure>"
  std::vector<std::pair<std::string, double>> seconds;  // wall time of each part
};

// Runs the stages of a plan, if it has any, takes the packing at their end as at rest, and writes the
// directory: modes.csv, floppy.csv, density.csv, elastic.csv, loads.csv, load_bodies.csv, load_contacts.csv,
// charts/, images/, modes.json. Throws Error (bad_input) before anything is written if the packing has no
// contacts, a law no derivative, or, for elastic constants, other walls; or as a run does.
Vibration vibrate(const scenario::Plan& plan, const VibrationOptions& options);

// The result for people.
std::string text_report(const Vibration& vibration);

}  // namespace scree::modes
