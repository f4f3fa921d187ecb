#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace scree::pictures {

// Adds an unlit actor that shows the data; returns its properties, for colour and line width.
inline vtkProperty* add_flat_actor(vtkRenderer* renderer, vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
  return actor->GetProperty();
}

}  // namespace scree::pictures
