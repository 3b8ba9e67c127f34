// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * \class vtkFoamBubblesRepresentation
 * \brief ParaView's surfaces for polygons that are not convex: bubbles, filled to their outline.
 *
 * ParaView fills polygons as if they were convex, unless they are cut into triangles. Here they
 * are, where they are filled. Edges are the polygons' own, and the cells that are picked are
 * polygons.
 */
#ifndef vtkFoamBubblesRepresentation_h
#define vtkFoamBubblesRepresentation_h

#include "vtkFoamRenderingModule.h" // for the export macro
#include "vtkGeometryRepresentationWithFaces.h"

class VTKFOAMRENDERING_EXPORT vtkFoamBubblesRepresentation
    : public vtkGeometryRepresentationWithFaces {
public:
  static vtkFoamBubblesRepresentation* New();
  vtkTypeMacro(vtkFoamBubblesRepresentation, vtkGeometryRepresentationWithFaces);

  using Superclass::SetRepresentation;
  void SetRepresentation(int type) override;
  /// Has no effect: polygons are cut where they have to be.
  void SetTriangulate(int) {}

protected:
  vtkFoamBubblesRepresentation();
  ~vtkFoamBubblesRepresentation() override = default;

private:
  vtkFoamBubblesRepresentation(const vtkFoamBubblesRepresentation&) = delete;
  void operator=(const vtkFoamBubblesRepresentation&) = delete;
};

#endif
