#pragma once

#include <memory>
#include <vector>

#include <scree/snapshot/picture.hpp>

class vtkRenderer;

namespace scree::snapshot {

// Pixels drawn per pixel of the picture, along each side: the average of 2 x 2 smooths edges and text.
int supersampling(int width, int height);

// Throws scree::Error unless both sides are within 200 to 8000 pixels.
void check_size(int width, int height);

// A software OpenGL context without a display, made at the first picture and kept.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  // What the renderers show, the later above the earlier, at supersampling times the size and averaged down
  // to it.
  Picture draw(int width, int height, const std::vector<vtkRenderer*>& renderers);

 private:
  struct Window;
  std::unique_ptr<Window> window_;
};

}  // namespace scree::snapshot
