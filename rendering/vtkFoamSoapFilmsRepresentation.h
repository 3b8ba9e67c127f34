// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * \class vtkFoamSoapFilmsRepresentation
 * \brief ParaView's representation "Soap Films": polygons in the colours of soap films.
 *
 * Each polygon is a soap film of a thickness (nm), in daylight before a black background. Its
 * colours are those of white light that interferes with itself, looked up pixel by pixel in a table
 * that is computed from the optics of a thin film: see core/optics/thin_film.h.
 */
#ifndef vtkFoamSoapFilmsRepresentation_h
#define vtkFoamSoapFilmsRepresentation_h

#include "vtkFoamRenderingModule.h" // for the export macro
#include "vtkGeometryRepresentation.h"
#include "vtkNew.h" // for members

class vtkLookupTable;

namespace foam { // VTK's wrappers do not know nested names
namespace rendering {
class SoapThickness;
}
} // namespace foam

class VTKFOAMRENDERING_EXPORT vtkFoamSoapFilmsRepresentation : public vtkGeometryRepresentation {
public:
  static vtkFoamSoapFilmsRepresentation* New();
  vtkTypeMacro(vtkFoamSoapFilmsRepresentation, vtkGeometryRepresentation);

  /// Cell array of thicknesses (nm); none for the same thickness everywhere.
  void SetThicknessArray(const char* name);
  /// Thickness (nm) in the middle of the data, without an array.
  void SetThickness(double thickness);
  /// How much thicker the film is per cm downwards from the middle of the data (nm/cm).
  void SetThicknessGradient(double gradient);
  /// Refractive index of the liquid, greater than 1.
  void SetRefractiveIndex(double index);

protected:
  vtkFoamSoapFilmsRepresentation();
  ~vtkFoamSoapFilmsRepresentation() override;

  void UpdateColoringParameters() override;

private:
  vtkFoamSoapFilmsRepresentation(const vtkFoamSoapFilmsRepresentation&) = delete;
  void operator=(const vtkFoamSoapFilmsRepresentation&) = delete;

  vtkNew<vtkLookupTable> Colours;
  foam::rendering::SoapThickness* SoapThickness;
};

#endif
