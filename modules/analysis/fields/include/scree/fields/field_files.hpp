#pragma once

#include <string>
#include <vector>

#include <scree/fields/field_sums.hpp>

namespace scree::fields {

// Fields at one time, or the mean of several.
struct FieldFrame {
  double time = 0;  // (s)
  std::vector<FieldPoint> points;
};

// A table with a row for each time and point: time and place, then every field; units in the header.
// comments: lines without a "#".
std::string format_csv(const FieldGrid& grid, const std::vector<FieldFrame>& frames,
                       const std::vector<std::string>& comments);
// Its header, with the end of the line, and the rows of one time.
std::string format_csv_header(int dimension);
std::string format_csv_rows(const FieldGrid& grid, const FieldFrame& frame);

// An image of VTK (.vti) with one array of point data for each field, as text; ParaView reads it.
std::string format_vti(const FieldGrid& grid, const FieldFrame& frame);

// A collection (.pvd) of files at times (s).
struct TimedFile {
  double time;
  std::string file;  // relative to the collection
};
std::string format_pvd(const std::vector<TimedFile>& files);

}  // namespace scree::fields
