#pragma once

#include "color_field.hpp"
#include "scene_camera.hpp"

#include <string>

#include <vtkContextItem.h>

namespace scree::snapshot {

// Division of a picture, in drawn pixels from the lower left: caption on top, note below, colour bar and
// triad on the right, scene in what is left.
struct SceneLayout {
  int width;
  int height;
  int pixel_scale;  // drawn pixels per pixel of the picture
  double font;      // height of the labels

  static SceneLayout of_size(int width, int height);
  double side() const { return 8.5 * font; }
  double caption() const { return 2.8 * font; }
  double note() const { return 2.0 * font; }
  double scene_width() const { return width - side(); }
  double scene_height() const { return height - caption() - note(); }
};

// All that is written and drawn around the scene.
class Panel : public vtkContextItem {
 public:
  static Panel* New();
  vtkTypeMacro(Panel, vtkContextItem)

      bool Paint(vtkContext2D* painter) override;

  SceneLayout layout{};
  ViewAxes axes{};
  std::string title;
  std::string time;
  std::string note;
  const ColorField* field = nullptr;  // null: no particles, no bar

 private:
  void paint_caption(vtkContext2D* painter) const;
  void paint_color_bar(vtkContext2D* painter) const;
  void paint_triad(vtkContext2D* painter) const;
};

}  // namespace scree::snapshot
