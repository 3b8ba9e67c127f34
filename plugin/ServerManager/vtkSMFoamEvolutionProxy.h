// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamEvolutionProxy
 * @brief Tells what FoamCoarsen or FoamDeform knows of its times as soon as it knows it.
 *
 * Where a run ends, and where one begins that goes on from another, is known when frames have been
 * computed: the properties that are for information are renewed then, and with them the time line.
 */
#ifndef vtkSMFoamEvolutionProxy_h
#define vtkSMFoamEvolutionProxy_h

#include "vtkFoamServerManagerModule.h" // for the export macro
#include "vtkSMSourceProxy.h"

class VTKFOAMSERVERMANAGER_EXPORT vtkSMFoamEvolutionProxy : public vtkSMSourceProxy {
public:
  static vtkSMFoamEvolutionProxy* New();
  vtkTypeMacro(vtkSMFoamEvolutionProxy, vtkSMSourceProxy);

  void PostUpdateData(bool usingCache) override;

protected:
  vtkSMFoamEvolutionProxy() = default;
  ~vtkSMFoamEvolutionProxy() override = default;

private:
  vtkSMFoamEvolutionProxy(const vtkSMFoamEvolutionProxy&) = delete;
  void operator=(const vtkSMFoamEvolutionProxy&) = delete;
};

#endif
