#include "averaged_pixels.hpp"

#include <GL/osmesa.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

namespace scree::pictures {

Picture AveragedPixels::read(vtkOpenGLRenderWindow* window, int width, int height) {
  vtkOpenGLState* const state = window->GetState();
  state->PushFramebufferBindings();
  buffer_->SetContext(window);
  if (buffer_->GetFBOIndex() == 0)
    buffer_->PopulateFramebuffer(width, height);
  else
    buffer_->Resize(width, height);
  buffer_->Bind(GL_DRAW_FRAMEBUFFER);
  buffer_->ActivateDrawBuffer(0);
  vtkOpenGLFramebufferObject* const drawn = window->GetRenderFramebuffer();
  drawn->Bind(GL_READ_FRAMEBUFFER);
  drawn->ActivateReadBuffer(0);
  // Linear interpolation at the corner of four pixels is their mean. Rows turn from bottom-up to top-down.
  const int* const size = drawn->GetLastSize();
  const int from[] = {0, size[0], 0, size[1]}, to[] = {0, width, height, 0};
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  vtkOpenGLFramebufferObject::Blit(from, to, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  buffer_->Bind(GL_READ_FRAMEBUFFER);
  buffer_->ActivateReadBuffer(0);
  Picture picture{width, height, std::vector<std::uint8_t>(3 * std::size_t(width) * std::size_t(height))};
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
  state->PopFramebufferBindings();
  return picture;
}

}  // namespace scree::pictures
