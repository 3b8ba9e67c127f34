// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * \class vtkFoamFilmsRepresentation
 * \brief ParaView's representation "Foam Films": films drawn as arcs.
 *
 * A representation of geometry with vtkFoamFilmMapper for a mapper. There is no level of detail:
 * the films are drawn whole also while one moves, from what is on the graphics card already.
 */
#ifndef vtkFoamFilmsRepresentation_h
#define vtkFoamFilmsRepresentation_h

#include "vtkFoamRenderingModule.h" // for the export macro
#include "vtkGeometryRepresentation.h"

class VTKFOAMRENDERING_EXPORT vtkFoamFilmsRepresentation : public vtkGeometryRepresentation {
public:
  static vtkFoamFilmsRepresentation* New();
  vtkTypeMacro(vtkFoamFilmsRepresentation, vtkGeometryRepresentation);

  /// Width of a film in pixels, at any zoom.
  void SetFilmWidth(double width);
  /// Radius (cm) of the sides of Plateau borders; 0 for a dry foam.
  void SetBorderRadius(double radius);

  /// One of vtkFoamFilmMapper::Styles.
  void SetFilmStyle(int style);
  /// A picture file for the style Texture; warns if it cannot be read.
  void SetFilmTextureFile(const char* path);

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* in,
                         vtkInformation* out) override;

protected:
  vtkFoamFilmsRepresentation();
  ~vtkFoamFilmsRepresentation() override = default;

  /// The films of a foam are in one process: nothing is to be redistributed to blend them in order.
  bool NeedsOrderedCompositing() override { return false; }

private:
  vtkFoamFilmsRepresentation(const vtkFoamFilmsRepresentation&) = delete;
  void operator=(const vtkFoamFilmsRepresentation&) = delete;
};

#endif
