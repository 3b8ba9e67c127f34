// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamStatisticsProxy.h"

#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "vtkCollection.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMVectorProperty.h"
#include "vtkSMViewProxy.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkSMFoamStatisticsProxy);

namespace {

/// Outputs of FoamStatistics, and of the filters that make films.
constexpr unsigned int ROWS_OF_BUBBLES = 2;
constexpr unsigned int DISTRIBUTION = 3;
constexpr unsigned int BUBBLES = 1;

constexpr vtkIdType ANY_PROCESS = -1; ///< in a selection

using Rows = std::set<vtkIdType>;

/// The rows of a selection, or of the selections that it is put together from.
Rows SelectedRows(vtkSMProxy* selection) {
  Rows rows;
  if (!selection) {
    return rows;
  }
  if (auto* ids = vtkSMVectorProperty::SafeDownCast(selection->GetProperty("IDs"))) {
    // Tuples that end in the row: of process and row or, from a chart, of block, process and row.
    const auto size = static_cast<std::size_t>(ids->GetNumberOfElementsPerCommand());
    const auto tuples = vtkSMPropertyHelper(ids).GetIdTypeArray();
    for (std::size_t i = size; i <= tuples.size(); i += size) {
      rows.insert(tuples[i - 1]);
    }
  } else if (vtkSMProperty* parts = selection->GetProperty("Input")) {
    const vtkSMPropertyHelper helper(parts);
    for (unsigned int i = 0; i < helper.GetNumberOfElements(); ++i) {
      rows.merge(SelectedRows(helper.GetAsProxy(i)));
    }
  }
  return rows;
}

vtkSmartPointer<vtkSMSourceProxy> NewSelection(vtkSMSourceProxy* owner, const char* kind) {
  return vtkSmartPointer<vtkSMSourceProxy>::Take(
      vtkSMSourceProxy::SafeDownCast(owner->GetSessionProxyManager()->NewProxy("sources", kind)));
}

/// The bubbles of a table's rows, which are in the same order.
vtkSmartPointer<vtkSMSourceProxy> SelectBubbles(vtkSMSourceProxy* owner, const Rows& rows) {
  auto selection = NewSelection(owner, "IDSelectionSource");
  vtkSMPropertyHelper(selection, "FieldType").Set(vtkSelectionNode::CELL);
  std::vector<vtkIdType> ids; // pairs of process and bubble
  for (const vtkIdType row : rows) {
    ids.insert(ids.end(), {ANY_PROCESS, row});
  }
  vtkSMPropertyHelper(selection, "IDs").Set(ids.data(), static_cast<unsigned int>(ids.size()));
  return selection;
}

/// The bubbles that are counted in rows of the distribution, each of one number of sides more than
/// the row before.
vtkSmartPointer<vtkSMSourceProxy> SelectBySides(vtkSMSourceProxy* owner, const Rows& rows) {
  const auto* sides =
      owner->GetDataInformation(DISTRIBUTION)->GetArrayInformation("Sides", vtkDataObject::ROW);
  const auto first = static_cast<vtkIdType>(sides->GetComponentRange(0)[0]);
  std::ostringstream query;
  query << '(';
  for (const vtkIdType row : rows) {
    query << (row == *rows.begin() ? "" : " | ") << "(Sides == " << first + row << ')';
  }
  query << ')';
  if (!vtkSMPropertyHelper(owner, "IncludeBoundary").GetAsInt()) {
    query << " & (OnBoundary == 0)";
  }
  auto selection = NewSelection(owner, "SelectionQuerySource");
  vtkSMPropertyHelper(selection, "ElementType").Set(vtkDataObject::CELL);
  vtkSMPropertyHelper(selection, "QueryString").Set(query.str().c_str());
  return selection;
}

void RenderViewsOf(vtkSMSourceProxy* source, int port) {
  vtkNew<vtkCollection> views;
  source->GetSessionProxyManager()->GetProxies("views", views);
  for (int i = 0; i < views->GetNumberOfItems(); ++i) {
    auto* view = vtkSMViewProxy::SafeDownCast(views->GetItemAsObject(i));
    if (view && view->FindRepresentation(source, port)) {
      view->StillRender();
    }
  }
}

} // namespace

vtkSMFoamStatisticsProxy::vtkSMFoamStatisticsProxy() {
  this->AddObserver(vtkCommand::SelectionChangedEvent, this,
                    &vtkSMFoamStatisticsProxy::PassSelectionOn);
}

void vtkSMFoamStatisticsProxy::PassSelectionOn(vtkObject*, unsigned long, void* portIndex) {
  const unsigned int port = *static_cast<unsigned int*>(portIndex);
  auto* films = vtkSMSourceProxy::SafeDownCast(vtkSMPropertyHelper(this, "Input").GetAsProxy());
  const char* name = films ? films->GetOutputPortName(BUBBLES) : nullptr;
  if ((port != ROWS_OF_BUBBLES && port != DISTRIBUTION) || !name ||
      std::strcmp(name, "Bubbles") != 0) {
    return;
  }
  const Rows rows = SelectedRows(this->GetSelectionInput(port));
  if (!rows.empty()) {
    const auto selection =
        port == DISTRIBUTION ? SelectBySides(this, rows) : SelectBubbles(this, rows);
    selection->UpdateVTKObjects();
    const auto appended = vtkSmartPointer<vtkSMProxy>::Take(
        vtkSMSelectionHelper::NewAppendSelectionsFromSelectionSource(selection));
    this->Passed = vtkSMSourceProxy::SafeDownCast(appended);
    films->SetSelectionInput(BUBBLES, this->Passed, 0);
  } else if (this->Passed && films->GetSelectionInput(BUBBLES) == this->Passed) {
    films->CleanSelectionInputs(BUBBLES);
  }
  RenderViewsOf(films, BUBBLES);
}
