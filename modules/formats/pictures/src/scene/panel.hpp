#pragma once

#include "color_field.hpp"
#include "scene_camera.hpp"

#include <string>

#include <vtkContextItem.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace scree::pictures {

// Layout of a picture, in drawn pixels from the lower left: caption on top, note below, colour bar and axes
// triad on the right, scene in the remaining area.
struct SceneLayout {
  int width;
  int height;
  int pixel_scale;  // drawn pixels per pixel of the picture
  double font;      // height of the labels

  double scale_strip;  // height of the strip of the scale bar, above the note

  static SceneLayout of_size(int width, int height, bool scale_bar);
  double side() const { return 8.5 * font; }
  double caption() const { return 2.8 * font; }
  double note() const { return 2.0 * font + scale_strip; }
  double scene_width() const { return width - side(); }
  double scene_height() const { return height - caption() - note(); }
};

// Text, colour bar and triad around the scene.
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
  const ColorField* field = nullptr;  // null: no particles, so no colour bar
  double scale_bar = 0;               // (m) its length; 0: none
  double pixels_per_metre = 0;
  vtkSmartPointer<vtkImageData> shade{};  // drawn over the scene, from its lower left; null: none

 private:
  void paint_caption(vtkContext2D* painter) const;
  void paint_color_bar(vtkContext2D* painter) const;
  void paint_legend(vtkContext2D* painter, const std::vector<ColorField::Entry>& legend) const;
  void paint_scale_bar(vtkContext2D* painter) const;
  void paint_triad(vtkContext2D* painter) const;
};

}  // namespace scree::pictures
