#include "pvd_index.hpp"

#include "vtk_messages.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <tuple>

#include <fmt/format.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>

namespace scree::pictures {
namespace {

vtkSmartPointer<vtkXMLDataElement> read_collection(const std::filesystem::path& pvd_file) {
  VtkMessages quiet;
  const auto root =
      vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(pvd_file.c_str()));
  const bool is_collection = root && root->GetName() && std::strcmp(root->GetName(), "VTKFile") == 0;
  vtkXMLDataElement* collection = is_collection ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!collection)
    throw Error(
        fmt::format("{}: is not a ParaView collection; move it away to start a new one", pvd_file.string()));
  return collection;
}

double parse_time(const char* text) {
  double time = 0;
  if (text) std::from_chars(text, text + std::strlen(text), time);
  return time;
}

}  // namespace

PvdIndex::PvdIndex(std::filesystem::path pvd_file) : pvd_file_(std::move(pvd_file)) {
  if (!std::filesystem::exists(pvd_file_)) return;
  const auto collection = read_collection(pvd_file_);
  for (int k = 0; k < collection->GetNumberOfNestedElements(); ++k) {
    vtkXMLDataElement* data_set = collection->GetNestedElement(k);
    const char* file_name = data_set->GetAttribute("file");
    if (file_name && std::filesystem::exists(pvd_file_.parent_path() / file_name))
      entries_.push_back({parse_time(data_set->GetAttribute("timestep")), file_name});
  }
}

void PvdIndex::put(const std::string& file_name, double time) {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.file_name == file_name; });
  entries_.push_back({time, file_name});
}

std::optional<double> PvdIndex::time_of(const std::string& file_name) const {
  for (const Entry& entry : entries_)
    if (entry.file_name == file_name) return entry.time;
  return std::nullopt;
}

void PvdIndex::save() {
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.time, a.file_name) < std::tie(b.time, b.file_name);
  });
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const Entry& entry : entries_)
    text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.time,
                        entry.file_name);
  text += "  </Collection>\n</VTKFile>\n";
  files::write_in_folder(pvd_file_, text);
}

}  // namespace scree::pictures
