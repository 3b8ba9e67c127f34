// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamCoarsenProxy
 * @brief Tells what FoamCoarsen knows of its times as soon as it knows it.
 *
 * Where a run ends, and where one begins that goes on from another, is known when frames have been
 * computed: the properties that are for information are renewed then, and with them the time line.
 */
#ifndef vtkSMFoamCoarsenProxy_h
#define vtkSMFoamCoarsenProxy_h

#include "vtkFoamServerManagerModule.h" // for the export macro
#include "vtkSMSourceProxy.h"

class VTKFOAMSERVERMANAGER_EXPORT vtkSMFoamCoarsenProxy : public vtkSMSourceProxy {
public:
  static vtkSMFoamCoarsenProxy* New();
  vtkTypeMacro(vtkSMFoamCoarsenProxy, vtkSMSourceProxy);

  void PostUpdateData(bool usingCache) override;

protected:
  vtkSMFoamCoarsenProxy() = default;
  ~vtkSMFoamCoarsenProxy() override = default;

private:
  vtkSMFoamCoarsenProxy(const vtkSMFoamCoarsenProxy&) = delete;
  void operator=(const vtkSMFoamCoarsenProxy&) = delete;
};

#endif
