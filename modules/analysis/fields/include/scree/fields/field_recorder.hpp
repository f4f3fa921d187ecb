#pragma once

#include <string>
#include <vector>

#include <scree/fields/averaging_kernel.hpp>
#include <scree/fields/field_files.hpp>
#include <scree/fields/field_grid.hpp>
#include <scree/fields/field_input.hpp>
#include <scree/fields/grid_request.hpp>

namespace scree::fields {

// Incremented when this interface or a struct in it changes; loader and library must have the same version.
inline constexpr int recorder_version = 1;

// Where and with which kernel fields are computed, the same at all times of a run.
struct FieldSetting {
  FieldGrid grid;
  AveragingKernel kernel;
};

// Makes the files of the fields of a run that goes on, with the functions that `scree fields` uses. It lies
// in a library of its own, which a run without [[fields]] needs not.
class FieldRecorder {
 public:
  virtual ~FieldRecorder() = default;

  // The setting that is asked for; what is not given follows from the input. Throws Error (place: the key) as
  // grid_for().
  virtual FieldSetting setting(const GridRequest& request, const FieldInput& input) = 0;
  // A whole .vti of one time; or the rows of one time of a .csv, whose header is csv_header(). threads: any
  // number gives the same bits.
  virtual std::string vti(const FieldSetting& setting, const FieldInput& input, unsigned threads) = 0;
  virtual std::string csv_rows(const FieldSetting& setting, const FieldInput& input, unsigned threads) = 0;
  virtual std::string csv_header(int dimension) = 0;
  virtual std::string pvd(const std::vector<TimedFile>& files) = 0;
};

// Loads libscree_field_recorder.so, once, and in a build tree builds it first if it is missing. Throws Error
// if there is none, or it is broken or outdated.
FieldRecorder& load_recorder();

}  // namespace scree::fields
