#include "vtk_messages.hpp"

#include <vtkObjectFactory.h>

namespace scree::pictures {

class VtkMessages::Collector : public vtkOutputWindow {
 public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow)

      void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override { ++errors; }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}

  int errors = 0;
};

vtkStandardNewMacro(VtkMessages::Collector)

    VtkMessages::VtkMessages()
    : collector_(vtkSmartPointer<Collector>::New()),
      previous_(vtkOutputWindow::GetInstance()),
      previous_verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
  vtkOutputWindow::SetInstance(collector_);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages() {
  vtkOutputWindow::SetInstance(previous_);
  vtkLogger::SetStderrVerbosity(previous_verbosity_);
}

bool VtkMessages::has_errors() const { return collector_->errors > 0; }

}  // namespace scree::pictures
