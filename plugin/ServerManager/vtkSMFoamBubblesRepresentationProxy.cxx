// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamBubblesRepresentationProxy.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMFoamBubblesRepresentationProxy);

int vtkSMFoamBubblesRepresentationProxy::ReadXMLAttributes(vtkSMSessionProxyManager* manager,
                                                           vtkPVXMLElement* element) {
  const int read = this->Superclass::ReadXMLAttributes(manager, element);
  this->GetSubProxy("SurfaceRepresentation")->SetVTKClassName("vtkFoamBubblesRepresentation");
  return read;
}
