// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamFromPolygons
 * @brief Builds a two-dimensional dry foam from polygons that share points, one bubble per polygon.
 *
 * The foam has the polygons' neighbours and, as its target areas, their areas; BubbleId is the
 * number of the cell. Points in which two polygons alone meet lie on one film: the arc that has the
 * line's ends and its area. Points in the same place are one. Polygons must lie in a plane of
 * constant z; cells that are no polygons are left out.
 *
 * Polygons that overlap, leave a gap or a hole, meet a side with a corner or do not hang together
 * are one error that names the cells.
 *
 * @sa vtkFoamFromPoints vtkFoamFromRegions
 */
#ifndef vtkFoamFromPolygons_h
#define vtkFoamFromPolygons_h

#include "vtkFoamFromRegions.h"

class VTKFOAMFILTERS_EXPORT vtkFoamFromPolygons : public vtkFoamFromRegions {
public:
  static vtkFoamFromPolygons* New();
  vtkTypeMacro(vtkFoamFromPolygons, vtkFoamFromRegions);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundaryType { Free = 0, Container = 1 };

  ///@{
  /**
   * What the line round all regions is: Free (default), films that bulge into the world; Container,
   * a wall with its corners, along which films slide.
   */
  vtkSetClampMacro(Boundary, int, Free, Container);
  vtkGetMacro(Boundary, int);
  ///@}

protected:
  vtkFoamFromPolygons();
  ~vtkFoamFromPolygons() override;

  void MakeFoam(vtkInformation* request, vtkInformationVector** inputs,
                vtkInformationVector* outputs) override;

private:
  vtkFoamFromPolygons(const vtkFoamFromPolygons&) = delete;
  void operator=(const vtkFoamFromPolygons&) = delete;

  int Boundary = Free;
};

#endif
