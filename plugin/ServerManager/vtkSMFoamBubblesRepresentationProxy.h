// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamBubblesRepresentationProxy
 * @brief ParaView's representation of poly data, but for the class that draws surfaces:
 * vtkFoamBubblesRepresentation.
 */
#ifndef vtkSMFoamBubblesRepresentationProxy_h
#define vtkSMFoamBubblesRepresentationProxy_h

#include "vtkFoamServerManagerModule.h" // for the export macro
#include "vtkSMPVRepresentationProxy.h"

class VTKFOAMSERVERMANAGER_EXPORT vtkSMFoamBubblesRepresentationProxy
    : public vtkSMPVRepresentationProxy {
public:
  static vtkSMFoamBubblesRepresentationProxy* New();
  vtkTypeMacro(vtkSMFoamBubblesRepresentationProxy, vtkSMPVRepresentationProxy);

protected:
  vtkSMFoamBubblesRepresentationProxy() = default;
  ~vtkSMFoamBubblesRepresentationProxy() override = default;

  int ReadXMLAttributes(vtkSMSessionProxyManager* manager, vtkPVXMLElement* element) override;

private:
  vtkSMFoamBubblesRepresentationProxy(const vtkSMFoamBubblesRepresentationProxy&) = delete;
  void operator=(const vtkSMFoamBubblesRepresentationProxy&) = delete;
};

#endif
