// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamStartTimeDomain.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"

vtkStandardNewMacro(vtkSMFoamStartTimeDomain);

void vtkSMFoamStartTimeDomain::Update(vtkSMProperty*) {
  vtkSMProperty* const time = this->GetRequiredProperty("Time");
  if (time && vtkSMPropertyHelper(time).GetNumberOfElements() > 0) {
    vtkSMPropertyHelper(this->GetProperty()).Set(vtkSMPropertyHelper(time).GetAsDouble());
  }
}

int vtkSMFoamStartTimeDomain::SetDefaultValues(vtkSMProperty*, bool) {
  this->Update(nullptr);
  return 1;
}
