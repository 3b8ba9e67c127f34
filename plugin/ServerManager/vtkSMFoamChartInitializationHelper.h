// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamChartInitializationHelper
 * @brief Sets a new chart up as its XML says: what lies along x, and which series are shown, how.
 *
 *     <InitializationHelper class="vtkSMFoamChartInitializationHelper" x="Sides">
 *       <Series name="Fraction" label="this foam" color="0.1 0.3 0.5" line="1" marker="4"/>
 *     </InitializationHelper>
 *
 * Series that are not listed are hidden. line and marker are ParaView's numbers of styles and may
 * be missing, as bars have neither.
 */
#ifndef vtkSMFoamChartInitializationHelper_h
#define vtkSMFoamChartInitializationHelper_h

#include "vtkFoamServerManagerModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKFOAMSERVERMANAGER_EXPORT vtkSMFoamChartInitializationHelper
    : public vtkSMProxyInitializationHelper {
public:
  static vtkSMFoamChartInitializationHelper* New();
  vtkTypeMacro(vtkSMFoamChartInitializationHelper, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* chart, vtkPVXMLElement* xml, vtkMTimeType) override;

protected:
  vtkSMFoamChartInitializationHelper() = default;
  ~vtkSMFoamChartInitializationHelper() override = default;

private:
  vtkSMFoamChartInitializationHelper(const vtkSMFoamChartInitializationHelper&) = delete;
  void operator=(const vtkSMFoamChartInitializationHelper&) = delete;
};

#endif
