#include "png_file.hpp"

#include "vtk_messages.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>

namespace scree::pictures {

void write_png(const Picture& picture, const std::filesystem::path& file) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::size_t row_bytes = 3 * std::size_t(picture.width);
  for (int row = 0; row < picture.height; ++row)  // VTK counts rows from the bottom
    std::copy_n(picture.rgb.data() + row * row_bytes, row_bytes,
                static_cast<std::uint8_t*>(image->GetScalarPointer(0, picture.height - 1 - row, 0)));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetCompressionLevel(4);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  files::write_in_folder(
      file, {reinterpret_cast<const char*>(bytes->GetPointer(0)), std::size_t(bytes->GetNumberOfValues())});
}

Picture read_png(const std::filesystem::path& file) {
  VtkMessages messages;
  vtkNew<vtkPNGReader> reader;
  const bool readable = std::filesystem::is_regular_file(file) && reader->CanReadFile(file.c_str());
  if (readable) {
    reader->SetFileName(file.c_str());
    reader->Update();
  }
  vtkImageData* image = reader->GetOutput();
  const int components = image->GetNumberOfScalarComponents();
  if (!readable || messages.has_errors() || components < 3 || image->GetScalarType() != VTK_UNSIGNED_CHAR)
    throw Error(
        fmt::format("{}: is not a colour PNG file with 8 bits per channel; check the path", file.string()));
  const int* size = image->GetDimensions();
  Picture picture{size[0], size[1], {}};
  picture.rgb.reserve(3 * std::size_t(picture.width) * picture.height);
  for (int row = 0; row < picture.height; ++row)
    for (int x = 0; x < picture.width; ++x) {
      const auto* pixel =
          static_cast<const std::uint8_t*>(image->GetScalarPointer(x, picture.height - 1 - row, 0));
      picture.rgb.insert(picture.rgb.end(), pixel, pixel + 3);
    }
  return picture;
}

}  // namespace scree::pictures
