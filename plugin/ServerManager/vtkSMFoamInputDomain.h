// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMFoamInputDomain
 * @brief Which inputs a proxy takes: films, bubbles, or what is neither.
 *
 *     <FoamInputDomain name="foam" accepts="films bubbles"/>
 *
 * Films and bubbles are known by their arrays. `other` accepts all that is not a foam's. ParaView
 * greys out what an input is not in the domain of, and chooses writers by it.
 */
#ifndef vtkSMFoamInputDomain_h
#define vtkSMFoamInputDomain_h

#include <string> // for what is accepted

#include "vtkFoamServerManagerModule.h" // for the export macro
#include "vtkSMDomain.h"

class VTKFOAMSERVERMANAGER_EXPORT vtkSMFoamInputDomain : public vtkSMDomain {
public:
  static vtkSMFoamInputDomain* New();
  vtkTypeMacro(vtkSMFoamInputDomain, vtkSMDomain);

  int IsInDomain(vtkSMProperty* input) override;

protected:
  vtkSMFoamInputDomain() = default;
  ~vtkSMFoamInputDomain() override = default;

  int ReadXMLAttributes(vtkSMProperty* input, vtkPVXMLElement* element) override;

private:
  vtkSMFoamInputDomain(const vtkSMFoamInputDomain&) = delete;
  void operator=(const vtkSMFoamInputDomain&) = delete;

  std::string Accepted; ///< words, each with a space before and after
};

#endif
