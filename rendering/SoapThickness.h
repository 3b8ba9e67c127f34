// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <vtkPolyDataAlgorithm.h>

namespace foam::rendering {

/// Cuts polygons into triangles and gives each corner the thickness of the soap film there (nm),
/// the point array SoapThickness. Each triangle has its own points, so that neighbours may differ.
class SoapThickness : public vtkPolyDataAlgorithm {
public:
  static SoapThickness* New();
  vtkTypeMacro(SoapThickness, vtkPolyDataAlgorithm);

  static constexpr const char* kArray = "SoapThickness";

  /// Cell array of thicknesses (nm); empty for the same Thickness (nm) everywhere.
  vtkSetMacro(ThicknessArray, std::string);
  vtkSetMacro(Thickness, double);
  /// How much thicker the film is per cm downwards from the middle of the data (nm/cm).
  vtkSetMacro(Gradient, double);

protected:
  SoapThickness() = default;
  ~SoapThickness() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** input,
                  vtkInformationVector* output) override;

private:
  std::string ThicknessArray;
  double Thickness = 0;
  double Gradient = 0;
};

} // namespace foam::rendering
