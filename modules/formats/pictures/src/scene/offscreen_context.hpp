#pragma once

#include <memory>
#include <vector>

#include <scree/pictures/picture.hpp>

class vtkRenderer;

namespace scree::pictures {

// Pixels drawn per pixel of the picture, along each side; averaging 2 x 2 pixels smooths edges and text.
int supersampling(int width, int height);

// Throws scree::Error unless both sides are 200 to 8000 pixels long.
void check_size(int width, int height);

// A software OpenGL context without a display, created for the first picture and reused.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  // Draws the renderers, later ones on top, at `supersampling` times the size, and averages down.
  Picture draw(int width, int height, const std::vector<vtkRenderer*>& renderers);

 private:
  struct Window;
  std::unique_ptr<Window> window_;
};

}  // namespace scree::pictures
