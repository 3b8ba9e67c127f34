// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamStartTimeDomain
 * @brief Gives a property the time of the input that a run begins with, for the panel to show.
 *
 *     <FoamStartTimeDomain name="time">
 *       <RequiredProperties>
 *         <Property name="Input" function="Input"/>
 *         <Property name="StartFrom" function="StartFrom"/>
 *       </RequiredProperties>
 *     </FoamStartTimeDomain>
 */
#ifndef vtkSMFoamStartTimeDomain_h
#define vtkSMFoamStartTimeDomain_h

#include "vtkFoamServerManagerModule.h" // for the export macro
#include "vtkSMDomain.h"

class VTKFOAMSERVERMANAGER_EXPORT vtkSMFoamStartTimeDomain : public vtkSMDomain {
public:
  static vtkSMFoamStartTimeDomain* New();
  vtkTypeMacro(vtkSMFoamStartTimeDomain, vtkSMDomain);

  void Update(vtkSMProperty* changed) override;

protected:
  vtkSMFoamStartTimeDomain() = default;
  ~vtkSMFoamStartTimeDomain() override = default;

private:
  vtkSMFoamStartTimeDomain(const vtkSMFoamStartTimeDomain&) = delete;
  void operator=(const vtkSMFoamStartTimeDomain&) = delete;
};

#endif
