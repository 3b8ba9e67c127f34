// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMFoamChartInitializationHelper.h"

#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMFoamChartInitializationHelper);

namespace {

constexpr int MARKER_SIZE = 8; // pixels

} // namespace

void vtkSMFoamChartInitializationHelper::PostInitializeProxy(vtkSMProxy* chart,
                                                             vtkPVXMLElement* xml, vtkMTimeType) {
  vtkSMPropertyHelper(chart, "UseIndexForXAxis").Set(0);
  vtkSMPropertyHelper(chart, "XArrayName").Set(xml->GetAttribute("x"));

  vtkSMPropertyHelper visibility(chart, "SeriesVisibility");
  const vtkSMPropertyHelper input(chart, "Input");
  auto* columns = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy())
                      ->GetDataInformation(input.GetOutputPort())
                      ->GetRowDataInformation();
  for (int i = 0; i < columns->GetNumberOfArrays(); ++i) {
    visibility.SetStatus(columns->GetArrayInformation(i)->GetName(), 0);
  }
  for (unsigned int i = 0; i < xml->GetNumberOfNestedElements(); ++i) {
    vtkPVXMLElement* series = xml->GetNestedElement(i);
    const char* name = series->GetAttribute("name");
    visibility.SetStatus(name, 1);
    vtkSMPropertyHelper(chart, "SeriesLabel").SetStatus(name, series->GetAttribute("label"));
    double colour[3];
    series->GetVectorAttribute("color", 3, colour);
    vtkSMPropertyHelper(chart, "SeriesColor").SetStatus(name, colour, 3);
    int style = 0;
    if (series->GetScalarAttribute("line", &style)) {
      vtkSMPropertyHelper(chart, "SeriesLineStyle").SetStatus(name, style);
    }
    if (series->GetScalarAttribute("marker", &style)) {
      vtkSMPropertyHelper(chart, "SeriesMarkerStyle").SetStatus(name, style);
      vtkSMPropertyHelper(chart, "SeriesMarkerSize").SetStatus(name, MARKER_SIZE);
    }
  }
  chart->UpdateVTKObjects();
}
