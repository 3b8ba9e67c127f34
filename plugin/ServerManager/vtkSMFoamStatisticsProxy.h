// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamStatisticsProxy
 * @brief Passes selections in the tables of FoamStatistics on to the bubbles.
 *
 * Rows selected in Bubbles select those bubbles, and bars selected in Distribution all bubbles with
 * so many sides that are counted there, in the output Bubbles of the filter that the films come
 * from. Films that come from elsewhere, from a file, say, have no bubbles to select.
 */
#ifndef vtkSMFoamStatisticsProxy_h
#define vtkSMFoamStatisticsProxy_h

#include "vtkFoamServerManagerModule.h" // for the export macro
#include "vtkSMSourceProxy.h"
#include "vtkWeakPointer.h" // for the selection

class VTKFOAMSERVERMANAGER_EXPORT vtkSMFoamStatisticsProxy : public vtkSMSourceProxy {
public:
  static vtkSMFoamStatisticsProxy* New();
  vtkTypeMacro(vtkSMFoamStatisticsProxy, vtkSMSourceProxy);

protected:
  vtkSMFoamStatisticsProxy();
  ~vtkSMFoamStatisticsProxy() override = default;

private:
  vtkSMFoamStatisticsProxy(const vtkSMFoamStatisticsProxy&) = delete;
  void operator=(const vtkSMFoamStatisticsProxy&) = delete;

  void PassSelectionOn(vtkObject*, unsigned long, void* port);

  vtkWeakPointer<vtkSMSourceProxy> Passed; ///< the selection that the bubbles were given
};

#endif
