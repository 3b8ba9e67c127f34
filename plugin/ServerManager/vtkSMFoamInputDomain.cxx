// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamInputDomain.h"

#include <algorithm>
#include <initializer_list>

#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

vtkStandardNewMacro(vtkSMFoamInputDomain);

namespace {

bool HasArrays(const vtkPVDataSetAttributesInformation* attributes,
               std::initializer_list<const char*> names) {
  return std::all_of(names.begin(), names.end(), [&](const char* name) {
    return attributes->GetArrayInformation(name) != nullptr;
  });
}

/// A word for what the data are.
const char* KindOf(const vtkPVDataInformation* data) {
  if (HasArrays(data->GetFieldDataInformation(), {"FormatVersion", "BubbleId"}) &&
      HasArrays(data->GetPointDataInformation(), {"JunctionId"}) &&
      HasArrays(data->GetCellDataInformation(), {"LeftBubble", "RightBubble", "HalfAngle"})) {
    return " films ";
  }
  const bool polygons = data->GetNumberOfPoints() > data->GetNumberOfCells(); // not their centres
  if (polygons && HasArrays(data->GetCellDataInformation(),
                            {"BubbleId", "Area", "TargetArea", "Pressure", "Sides"})) {
    return " bubbles ";
  }
  return " other ";
}

} // namespace

int vtkSMFoamInputDomain::IsInDomain(vtkSMProperty* input) {
  const vtkSMUncheckedPropertyHelper inputs(input);
  for (unsigned int i = 0; i < inputs.GetNumberOfElements(); ++i) {
    auto* source = vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy(i));
    if (!source) {
      return NOT_IN_DOMAIN;
    }
    source->CreateOutputPorts();
    const auto* data = source->GetDataInformation(inputs.GetOutputPort(i));
    if (!data || data->IsCompositeDataSet() ||
        this->Accepted.find(KindOf(data)) == std::string::npos) {
      return NOT_IN_DOMAIN;
    }
  }
  return IN_DOMAIN;
}

int vtkSMFoamInputDomain::ReadXMLAttributes(vtkSMProperty* input, vtkPVXMLElement* element) {
  const char* accepted = element->GetAttribute("accepts");
  this->Accepted = std::string(" ") + (accepted ? accepted : "") + " ";
  return this->Superclass::ReadXMLAttributes(input, element);
}
