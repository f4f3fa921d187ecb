#pragma once

#include <string>

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace scree::pictures {

// Collects the messages of VTK during its lifetime, instead of printing them to the terminal.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool has_errors() const;

 private:
  class Collector;
  vtkSmartPointer<Collector> collector_;
  vtkSmartPointer<vtkOutputWindow> previous_;
  vtkLogger::Verbosity previous_verbosity_;
};

}  // namespace scree::pictures
