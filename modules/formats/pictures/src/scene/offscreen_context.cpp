#include "offscreen_context.hpp"

#include "averaged_pixels.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <string>

#include <GL/osmesa.h>
#include <fmt/format.h>
#include <vtkDataArrayRange.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <scree/allowed_processors.hpp>
#include <scree/error.hpp>
#include <scree/threads.hpp>

namespace scree::pictures {
namespace {

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
  AveragedPixels averaged;

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
    // Pictures are read from where VTK draws; it would copy colours and depths to another frame buffer.
    vtk->SwapBuffersOff();
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
  for (vtkRenderer* renderer : renderers) vtk->RemoveRenderer(renderer);
}

Picture OffscreenContext::draw(int width, int height, const std::vector<vtkRenderer*>& renderers) {
  render(width, height, renderers);
  return window_->averaged.read(window_->vtk, width, height);
}

DepthField OffscreenContext::draw_depths(int width, int height, const std::vector<vtkRenderer*>& renderers,
                                         const Hollows& hollows) {
  render(width, height, renderers);
  vtkNew<vtkFloatArray> shares;  // of the range of depths
  window_->vtk->GetZbufferData(hollows.left, hollows.bottom, hollows.left + hollows.width - 1,
                               hollows.bottom + hollows.height - 1, shares);
  DepthField field = {hollows.width, hollows.height};
  for (const float share : vtk::DataArrayValueRange<1>(shares.Get()))
    field.depth.push_back(share < 1 ? float(-hollows.depth_range * share)
                                    : -std::numeric_limits<float>::infinity());
  return field;
}

}  // namespace scree::pictures
