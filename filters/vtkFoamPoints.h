// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamPoints
 * @brief Random points to build a foam from: the thesis's jittered grid.
 *
 * One point at a random place in each cell of a square grid, row by row. The same seed gives the
 * same points on every platform. The points lie in the plane z = 0, in double precision. The
 * rectangle that the cells fill is the field data PeriodicBounds: xmin, xmax, ymin, ymax, cm.
 *
 * Publication: B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex Model, University
 * of Copenhagen, 2010, section 4.5.3.
 *
 * @sa vtkFoamFromPoints
 */
#ifndef vtkFoamPoints_h
#define vtkFoamPoints_h

#include "vtkFoamFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFOAMFILTERS_EXPORT vtkFoamPoints : public vtkPolyDataAlgorithm {
public:
  static vtkFoamPoints* New();
  vtkTypeMacro(vtkFoamPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of points, ≥ 1. Default 2000.
   */
  vtkSetMacro(NumberOfPoints, int);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Side of a grid cell, cm, > 0. Default 1.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * How far a point may lie from the centre of its grid cell: 0 makes a square grid, 1 (default)
   * allows any place in the grid cell.
   */
  vtkSetMacro(Jitter, double);
  vtkGetMacro(Jitter, double);
  ///@}

  ///@{
  /**
   * Seed of the random numbers. Default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkFoamPoints();
  ~vtkFoamPoints() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkFoamPoints(const vtkFoamPoints&) = delete;
  void operator=(const vtkFoamPoints&) = delete;

  int NumberOfPoints = 2000;
  double Spacing = 1;
  double Jitter = 1;
  int Seed = 1;
};

#endif
