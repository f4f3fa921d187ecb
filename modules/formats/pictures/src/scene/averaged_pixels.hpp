#pragma once

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>

#include <scree/pictures/picture.hpp>

class vtkOpenGLRenderWindow;

namespace scree::pictures {

// Averages what a window has drawn by OpenGL, so that only the pixels of the picture are read back. Keeps its
// frame buffer for pictures of the same size.
class AveragedPixels {
 public:
  // Requires a window that has drawn this size, or twice it along each side.
  Picture read(vtkOpenGLRenderWindow* window, int width, int height);

 private:
  vtkNew<vtkOpenGLFramebufferObject> buffer_;
};

}  // namespace scree::pictures
