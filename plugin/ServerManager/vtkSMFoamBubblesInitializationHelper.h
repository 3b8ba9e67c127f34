// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamBubblesInitializationHelper
 * @brief How bubbles look at first: coloured by their number of sides.
 *
 * Colours run from three sides to nine, so that the middle of a diverging map is six: by von
 * Neumann's law bubbles on one side of it shrink and on the other grow. The bubbles that these came
 * from are hidden, as ParaView hides a filter's input.
 */
#ifndef vtkSMFoamBubblesInitializationHelper_h
#define vtkSMFoamBubblesInitializationHelper_h

#include "vtkFoamServerManagerModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKFOAMSERVERMANAGER_EXPORT vtkSMFoamBubblesInitializationHelper
    : public vtkSMProxyInitializationHelper {
public:
  static vtkSMFoamBubblesInitializationHelper* New();
  vtkTypeMacro(vtkSMFoamBubblesInitializationHelper, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* bubbles, vtkPVXMLElement*, vtkMTimeType) override;

protected:
  vtkSMFoamBubblesInitializationHelper() = default;
  ~vtkSMFoamBubblesInitializationHelper() override = default;

private:
  vtkSMFoamBubblesInitializationHelper(const vtkSMFoamBubblesInitializationHelper&) = delete;
  void operator=(const vtkSMFoamBubblesInitializationHelper&) = delete;
};

#endif
