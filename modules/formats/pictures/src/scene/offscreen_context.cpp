#include "offscreen_context.hpp"

#include "ambient_occlusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <GL/osmesa.h>
#include <fmt/format.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <scree/allowed_processors.hpp>
#include <scree/error.hpp>
#include <scree/threads.hpp>

namespace scree::pictures {
namespace {

// Averages blocks of scale x scale pixels and flips the rows, from bottom-up to top-down.
Picture average_down(const std::uint8_t* rgb, int width, int height, int scale) {
  Picture picture{width, height, std::vector<std::uint8_t>(3 * std::size_t(width) * height)};
  const std::size_t row_bytes = 3 * std::size_t(width) * scale;
  std::vector<int> sums(3 * std::size_t(width));
  for (int y = 0; y < height; ++y) {
    std::fill(sums.begin(), sums.end(), 0);
    for (int sub_row = 0; sub_row < scale; ++sub_row) {
      const std::uint8_t* row = rgb + (std::size_t(y) * scale + sub_row) * row_bytes;
      for (int x = 0; x < width; ++x)
        for (int k = 0; k < 3 * scale; ++k) sums[3 * x + k % 3] += row[3 * scale * x + k];
    }
    std::uint8_t* out = picture.rgb.data() + 3 * std::size_t(height - 1 - y) * width;
    const int pixels = scale * scale;
    for (std::size_t k = 0; k < sums.size(); ++k) out[k] = std::uint8_t((sums[k] + pixels / 2) / pixels);
  }
  return picture;
}

// rgb: of rows of `row_width` pixels; depths: 0 to 1, of the rows of the hollows.
void darken(std::uint8_t* rgb, int row_width, const Hollows& hollows, const float* depths) {
  DepthField field = {hollows.width, hollows.height};
  for (std::size_t k = 0; k < std::size_t(hollows.width) * std::size_t(hollows.height); ++k)
    field.depth.push_back(depths[k] < 1 ? float(-hollows.depth_range * depths[k])
                                        : -std::numeric_limits<float>::infinity());
  // Above 1, for a difference that is seen.
  constexpr float contrast = 1.5f;
  const std::vector<float> shares = open_shares(field, hollows.radius);
  for (int row = 0; row < hollows.height; ++row)
    for (int column = 0; column < hollows.width; ++column) {
      const float share =
          std::pow(shares[std::size_t(row) * std::size_t(hollows.width) + std::size_t(column)], contrast);
      std::uint8_t* const pixel = rgb + 3 * (std::size_t(hollows.bottom + row) * std::size_t(row_width) +
                                             std::size_t(hollows.left + column));
      for (int k = 0; k < 3; ++k) pixel[k] = std::uint8_t(std::lround(share * float(pixel[k])));
    }
}

// What is dark in either picture is dark.
void multiply(std::uint8_t* picture, const std::uint8_t* other, std::size_t values) {
  for (std::size_t k = 0; k < values; ++k) picture[k] = std::uint8_t((picture[k] * other[k] + 127) / 255);
}

// Mesa starts a thread per processor of the computer, also of those that this process may not use, and waits
// for ever for one that did not start; told so, it draws in this thread.
void draw_with_the_threads_there_are() {
  constexpr const char* variable = "LP_NUM_THREADS";
  constexpr unsigned most_of_mesa = 32, of_its_cache = 1;
  const char* chosen = std::getenv(variable);
  const unsigned wanted =
      std::min(chosen ? unsigned(std::strtoul(chosen, nullptr, 10)) : allowed_processors(), most_of_mesa);
  const bool possible = wanted == 0 || can_start_threads(wanted + of_its_cache);
  setenv(variable, possible ? std::to_string(wanted).c_str() : "0", 1);
}

}  // namespace

int supersampling(int width, int height) { return std::max(width, height) <= 4000 ? 2 : 1; }

void check_size(int width, int height) {
  if (std::min(width, height) < 200 || std::max(width, height) > 8000)
    throw Error(fmt::format("picture: size {} x {} is out of range; choose 200 to 8000 pixels per side",
                            width, height));
}

struct OffscreenContext::Window {
  OSMesaContext context;
  // VTK draws into its own frame buffers; OSMesa only requires some memory as its window.
  std::array<std::uint8_t, 4 * 16 * 16> surface{};
  vtkNew<vtkGenericOpenGLRenderWindow> vtk;

  Window() : context(create_context()) {
    make_current();
    vtk->SetOwnContext(0);
    vtk->SetOffScreenRendering(1);
    vtk->SetShowWindow(false);
    vtk->SetUseOffScreenBuffers(true);
    vtk->SetReadyForRendering(true);
    vtk->SetIsCurrent(true);
    vtk->SetSupportsOpenGL(1);
    vtk->SetMultiSamples(0);
    vtk->SetDPI(72);  // makes font sizes pixels
  }

  ~Window() {
    OSMesaMakeCurrent(context, surface.data(), GL_UNSIGNED_BYTE, 16, 16);
    vtk->Finalize();
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    OSMesaDestroyContext(context);
  }

  static OSMesaContext create_context() {
    draw_with_the_threads_there_are();
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              2,
                              0};
    OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context) throw Error("OSMesa: no OpenGL 3.2 core profile available; install a newer libosmesa6");
    return context;
  }

  void make_current() {
    if (!OSMesaMakeCurrent(context, surface.data(), GL_UNSIGNED_BYTE, 16, 16))
      throw Error("OSMesa: the software OpenGL context cannot be used; check the installation of libosmesa6");
  }
};

OffscreenContext::OffscreenContext() = default;
OffscreenContext::~OffscreenContext() = default;

void OffscreenContext::render(int width, int height, const std::vector<vtkRenderer*>& renderers) {
  if (!window_) window_ = std::make_unique<Window>();
  window_->make_current();
  vtkGenericOpenGLRenderWindow* vtk = window_->vtk;
  const int scale = supersampling(width, height);
  vtk->SetSize(width * scale, height * scale);
  vtk->SetNumberOfLayers(int(renderers.size()));
  for (std::size_t layer = 0; layer < renderers.size(); ++layer) {
    renderers[layer]->SetLayer(int(layer));
    vtk->AddRenderer(renderers[layer]);
  }
  vtk->Render();
}

vtkNew<vtkUnsignedCharArray> OffscreenContext::pixels(int width, int height) {
  const int scale = supersampling(width, height);
  vtkNew<vtkUnsignedCharArray> all;
  const int front = 1;
  const int right_eye = 0;
  window_->vtk->GetPixelData(0, 0, width * scale - 1, height * scale - 1, front, all, right_eye);
  return all;
}

Picture OffscreenContext::draw(int width, int height, const std::vector<vtkRenderer*>& renderers) {
  render(width, height, renderers);
  const vtkNew<vtkUnsignedCharArray> all = pixels(width, height);
  for (vtkRenderer* renderer : renderers) window_->vtk->RemoveRenderer(renderer);
  return average_down(all->GetPointer(0), width, height, supersampling(width, height));
}

Picture OffscreenContext::draw_with_shadows(int width, int height, const std::vector<vtkRenderer*>& scene,
                                            const std::vector<vtkRenderer*>& overlay,
                                            const Hollows& hollows) {
  render(width, height, scene);
  const vtkNew<vtkUnsignedCharArray> all = pixels(width, height);
  vtkNew<vtkFloatArray> depths;
  window_->vtk->GetZbufferData(hollows.left, hollows.bottom, hollows.left + hollows.width - 1,
                               hollows.bottom + hollows.height - 1, depths);
  for (vtkRenderer* renderer : scene) window_->vtk->RemoveRenderer(renderer);
  const int scale = supersampling(width, height);
  darken(all->GetPointer(0), width * scale, hollows, depths->GetPointer(0));
  render(width, height, overlay);
  const vtkNew<vtkUnsignedCharArray> above = pixels(width, height);
  for (vtkRenderer* renderer : overlay) window_->vtk->RemoveRenderer(renderer);
  multiply(all->GetPointer(0), above->GetPointer(0), std::size_t(all->GetNumberOfValues()));
  return average_down(all->GetPointer(0), width, height, scale);
}

}  // namespace scree::pictures
