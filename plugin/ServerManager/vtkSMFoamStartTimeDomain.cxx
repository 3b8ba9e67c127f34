// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamStartTimeDomain.h"

#include <vector>

#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

vtkStandardNewMacro(vtkSMFoamStartTimeDomain);

namespace {

/// The time that films carry themselves.
double CarriedTime(const vtkPVDataInformation* data) {
  const auto* time = data->GetFieldDataInformation()->GetArrayInformation("TimeValue");
  return time ? time->GetComponentRange(0)[0] : 0;
}

} // namespace

void vtkSMFoamStartTimeDomain::Update(vtkSMProperty*) {
  vtkSMProperty* const input = this->GetRequiredProperty("Input");
  vtkSMProperty* const from = this->GetRequiredProperty("StartFrom");
  if (!input || !from) {
    return;
  }
  const vtkSMUncheckedPropertyHelper inputs(input);
  auto* source = inputs.GetNumberOfElements() > 0
                     ? vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy())
                     : nullptr;
  if (!source) {
    return;
  }
  const bool last = vtkSMUncheckedPropertyHelper(from).GetAsInt() != 0;
  const std::vector<double> times =
      vtkSMPropertyHelper(source, "TimestepValues", true).GetDoubleArray();
  const double time = times.empty()
                          ? CarriedTime(source->GetDataInformation(inputs.GetOutputPort()))
                          : (last ? times.back() : times.front());
  vtkSMPropertyHelper(this->GetProperty()).Set(time);
}
