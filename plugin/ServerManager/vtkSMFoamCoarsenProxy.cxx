// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamCoarsenProxy.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMFoamCoarsenProxy);

void vtkSMFoamCoarsenProxy::PostUpdateData(bool usingCache) {
  this->Superclass::PostUpdateData(usingCache);
  if (!usingCache) {
    this->UpdatePipelineInformation();
  }
}
