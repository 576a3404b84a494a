// Keeps VTK's messages off stderr.
#pragma once

#include <vtkObject.h>

namespace volsurf {

/// While it lives, VTK prints no errors and no warnings; its filters and writers still return their error codes.
class QuietVtk {
public:
  QuietVtk() : display_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(display_); }
  QuietVtk(const QuietVtk &) = delete;
  QuietVtk &operator=(const QuietVtk &) = delete;

private:
  int display_;
};

} // namespace volsurf
