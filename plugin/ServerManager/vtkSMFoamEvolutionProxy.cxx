// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamEvolutionProxy.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMFoamEvolutionProxy);

void vtkSMFoamEvolutionProxy::PostUpdateData(bool usingCache) {
  this->Superclass::PostUpdateData(usingCache);
  if (!usingCache) {
    this->UpdatePipelineInformation();
  }
}
