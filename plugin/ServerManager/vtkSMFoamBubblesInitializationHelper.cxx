// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamBubblesInitializationHelper.h"

#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRepresentationProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"
#include "vtkSMViewProxy.h"

vtkStandardNewMacro(vtkSMFoamBubblesInitializationHelper);

namespace {

constexpr int BUBBLES = 1; ///< output of the filters that make a foam
constexpr double FEWEST_SIDES = 3;
constexpr double MOST_SIDES = 9;
constexpr int NEVER = -1; ///< ParaView's number for a colour map that keeps its range

vtkSMProxy* InputOf(vtkSMProxy* proxy) {
  vtkSMProperty* input = proxy ? proxy->GetProperty("Input") : nullptr;
  return input ? vtkSMPropertyHelper(input).GetAsProxy() : nullptr;
}

void ColourBySides(vtkSMProxy* bubbles) {
  vtkNew<vtkSMTransferFunctionManager> maps;
  vtkSMProxy* colours = maps->GetColorTransferFunction("Sides", bubbles->GetSessionProxyManager());
  vtkSMTransferFunctionProxy::RescaleTransferFunction(colours, FEWEST_SIDES, MOST_SIDES);
  vtkSMPropertyHelper(colours, "AutomaticRescaleRangeMode").Set(NEVER);
  colours->UpdateVTKObjects();
  vtkSMPropertyHelper(bubbles, "ColorArrayName")
      .SetInputArrayToProcess(vtkDataObject::CELL, "Sides");
  vtkSMPropertyHelper(bubbles, "LookupTable").Set(colours);
}

/// Hides, in the active view, the bubbles of the filter that made the input of these bubbles.
void HideEarlierBubbles(vtkSMProxy* bubbles) {
  auto* earlier = vtkSMSourceProxy::SafeDownCast(InputOf(InputOf(bubbles)));
  auto* active = bubbles->GetSessionProxyManager()->GetSelectionModel("ActiveView");
  auto* view = vtkSMViewProxy::SafeDownCast(active ? active->GetCurrentProxy() : nullptr);
  vtkSMProxy* shown = earlier && view ? view->FindRepresentation(earlier, BUBBLES) : nullptr;
  if (shown) {
    vtkSMPropertyHelper(shown, "Visibility").Set(0);
    shown->UpdateVTKObjects();
  }
}

} // namespace

void vtkSMFoamBubblesInitializationHelper::PostInitializeProxy(vtkSMProxy* bubbles,
                                                               vtkPVXMLElement*, vtkMTimeType) {
  ColourBySides(bubbles);
  bubbles->UpdateVTKObjects();
  HideEarlierBubbles(bubbles);
}
