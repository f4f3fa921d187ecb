#pragma once

#include "ambient_occlusion.hpp"
#include "sphere_visibility.hpp"

#include <memory>
#include <vector>

#include <scree/pictures/picture.hpp>

class vtkRenderer;

namespace scree::pictures {

// Pixels drawn per pixel of the picture, along each side; averaging 2 x 2 pixels smooths edges and text.
int supersampling(int width, int height);

// Throws scree::Error unless both sides are 200 to 8000 pixels long.
void check_size(int width, int height);

// Where hollows are darkened: columns and rows of drawn pixels from the lower left.
struct Hollows {
  int left, bottom, width, height;
  double depth_range;  // (pixels) from the nearest to the farthest depth that can be drawn
  double radius;       // (pixels) of the ball in which hollows are looked for
};

// A software OpenGL context without a display, created for the first picture and reused.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  // Draws the renderers, later ones on top, at `supersampling` times the size, and averages down.
  Picture draw(int width, int height, const std::vector<vtkRenderer*>& renderers);
  // Draws what a picture begins with; a renderer that erases nothing is drawn over it next. Depths (pixels)
  // grow towards the viewer and are minus infinity where nothing is.
  DepthField draw_depths(int width, int height, const std::vector<vtkRenderer*>& renderers,
                         const Hollows& hollows);

  DepthMemory depth_memory{};  // of the bodies of one picture after the other

 private:
  void render(int width, int height, const std::vector<vtkRenderer*>& renderers);
  struct Window;
  std::unique_ptr<Window> window_;
};

}  // namespace scree::pictures
