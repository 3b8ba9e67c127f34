// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamStartTimeDomain
 * @brief Gives a property the value of one that is for information only, which panels do not show.
 *
 *     <FoamStartTimeDomain name="time">
 *       <RequiredProperties>
 *         <Property name="StartTimeInForce" function="Time"/>
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
  int SetDefaultValues(vtkSMProperty* property, bool useUnchecked) override;

protected:
  vtkSMFoamStartTimeDomain() = default;
  ~vtkSMFoamStartTimeDomain() override = default;

private:
  vtkSMFoamStartTimeDomain(const vtkSMFoamStartTimeDomain&) = delete;
  void operator=(const vtkSMFoamStartTimeDomain&) = delete;
};

#endif
