#include "png_file.hpp"

#include "vtk_messages.hpp"

#include <csetjmp>
#include <new>
#include <string>

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtk_png.h>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>

namespace scree::pictures {
namespace {

extern "C" void append_png_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  try {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
  } catch (const std::bad_alloc&) {  // exceptions may not pass through libpng
    png_error(png, "no memory");
  }
}

// False if libpng fails. Nothing in it has a destructor, which setjmp would skip.
bool append_png(const Picture& picture, png_structp png, png_infop info, std::string& bytes) {
  if (!png || !info || setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &bytes, append_png_bytes, nullptr);
  png_set_IHDR(png, info, png_uint_32(picture.width), png_uint_32(picture.height), 8, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // A third of the time of level 4 with the best filter of each row, for files a tenth larger.
  png_set_compression_level(png, 1);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_write_info(png, info);
  for (int row = 0; row < picture.height; ++row)
    png_write_row(png, picture.rgb.data() + 3 * std::size_t(row) * std::size_t(picture.width));
  png_write_end(png, info);
  return true;
}

}  // namespace

// By libpng rather than VTK's writer, which leaves the choice of filters to it.
void write_png(const Picture& picture, const std::filesystem::path& file) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool complete = append_png(picture, png, info, bytes);
  png_destroy_write_struct(&png, &info);
  if (!complete)
    throw Error(fmt::format("{}: libpng cannot write the picture; free memory", file.string()),
                ExitStatus::failure);
  files::write_in_folder(file, bytes);
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
