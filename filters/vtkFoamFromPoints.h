// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamFromPoints
 * @brief Builds a two-dimensional dry foam from points, one bubble per point, in equilibrium.
 *
 * The points' Delaunay triangulation is the dual of the foam: a point becomes a bubble, an edge a
 * film, a triangle a junction. The foam is then brought to equilibrium: films are circular arcs
 * that meet three by three at 120°, and every bubble has its target area. Points must lie in a
 * plane of constant z; the foam lies in z = 0.
 *
 * Output port 0, films: a polyline per film, sampled along its arc. Cell data LeftBubble,
 * RightBubble (−1 = the world), Curvature (1/cm, > 0 where the film bulges to the right),
 * PressureDifference (left minus right, N/cm²), Length (cm), HalfAngle (rad), OnBoundary and, where
 * not all have 2γ, FilmTension (N/cm); point data JunctionId (−1 inside an arc); field data
 * BubbleId, BubblePressure (N/cm²), BubbleTargetArea (cm²) and the foam's own values. They are the
 * foam's whole state: a .vtp of them is a checkpoint.
 *
 * Output port 1, bubbles: a polygon per bubble. Cell data BubbleId, Area, TargetArea (cm²),
 * Pressure (N/cm²), Sides, Perimeter (cm), OnBoundary, Stress (N/cm², tension positive).
 *
 * Bad input gives one error that names the cause, and empty outputs.
 *
 * Publication: B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex Model, University
 * of Copenhagen, 2010, section 4.5.3.
 *
 * @sa vtkFoamPoints vtkFoamCoarsen
 */
#ifndef vtkFoamFromPoints_h
#define vtkFoamFromPoints_h

#include <memory> // for the options
#include <string> // for the name of an array

#include "vtkFoamEquilibratingAlgorithm.h"

#ifndef __VTK_WRAP__
namespace foam {
struct BuildOptions;
struct ContainerOptions;
struct Foam;
} // namespace foam
#endif

class VTKFOAMFILTERS_EXPORT vtkFoamFromPoints : public vtkFoamEquilibratingAlgorithm {
public:
  static vtkFoamFromPoints* New();
  vtkTypeMacro(vtkFoamFromPoints, vtkFoamEquilibratingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundaryType { Free = 0, Periodic = 1, Fixed = 2, Container = 3 };
  enum ContainerType { Rectangle = 0, Disc = 1, Annulus = 2, Channel = 3, Outline = 4 };
  enum WallContactType { Slip = 0, Pinned = 1 };
  enum TargetAreasType { Initial = 0, Uniform = 1, Array = 2 };

  ///@{
  /**
   * What surrounds the foam: Free (default), the world with pressure 0; Periodic, its own images on
   * a torus; Fixed, a sealed container of the shape that its first outline has, on which films are
   * pinned; Container, walls of a shape of its own.
   */
  foamChoiceMacro(Boundary, Free, Container);
  ///@}

  ///@{
  /**
   * The shape of a container: Rectangle (default), Disc, Annulus, Channel, which is periodic along
   * x and has walls along y, or Outline, the closed polylines of the second input, of which those
   * inside another are obstacles.
   */
  foamChoiceMacro(Container, Rectangle, Outline);
  ///@}

  ///@{
  /**
   * The bounds of a container: xmin, xmax, ymin, ymax, cm. A disc, or an annulus, is the largest in
   * them. Four zeros, the default, stand for bounds round the points.
   */
  vtkSetVector4Macro(ContainerBounds, double);
  vtkGetVector4Macro(ContainerBounds, double);
  ///@}

  ///@{
  /**
   * Radius of the obstacle in the middle of an annulus, cm. Default 1.
   */
  foamOptionMacro(InnerRadius, double);
  ///@}

  ///@{
  /**
   * How films end on the walls of a container: Slip (default), at 90°, and they slide along;
   * Pinned, where they are in the initial mesh.
   */
  foamChoiceMacro(WallContact, Slip, Pinned);
  ///@}

  /**
   * Walls for the container Outline: closed polylines or polygons.
   */
  void SetWallsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

  ///@{
  /**
   * The torus of a periodic foam: xmin, xmax, ymin, ymax, cm. Four zeros, the default, stand for
   * the rectangle that the points of vtkFoamPoints fill and, for other points, for their bounds
   * grown so that bubbles at the seam are as large as the others.
   */
  vtkSetVector4Macro(PeriodicBounds, double);
  vtkGetVector4Macro(PeriodicBounds, double);
  ///@}

  ///@{
  /**
   * The two periods of a torus that is no rectangle, counter-clockwise: h1x, h1y, h2x, h2y, cm. Its
   * cell begins in the lower left corner of PeriodicBounds or, where they are empty, of the points'
   * bounds. Four zeros, the default, stand for the rectangle of PeriodicBounds.
   */
  vtkSetVector4Macro(PeriodVectors, double);
  vtkGetVector4Macro(PeriodVectors, double);
  ///@}

  ///@{
  /**
   * Whether points that extend over more than the torus are folded onto it. Off by default: that is
   * an error.
   */
  foamOptionMacro(FoldPoints, bool);
  ///@}

  ///@{
  /**
   * Where the target areas come from: Initial (default), each bubble's area in the initial mesh;
   * Uniform, their mean for every bubble; Array, the point array TargetAreaArray.
   */
  foamChoiceMacro(TargetAreas, Initial, Array);
  ///@}

  ///@{
  /**
   * Name of the point array of target areas, cm², one value > 0 per point. On a torus and in a
   * container they must add up to its area, to 1 %; what they are off they are scaled by, with a
   * warning.
   */
  vtkSetStdStringFromCharMacro(TargetAreaArray);
  vtkGetCharFromStdStringMacro(TargetAreaArray);
  ///@}

  ///@{
  /**
   * Whether to scale the areas of the array whatever they add up to. Default off.
   */
  foamOptionMacro(FitAreas, bool);
  vtkBooleanMacro(FitAreas, bool);
  ///@}

  ///@{
  /**
   * Surface tension γ, N/cm, > 0; a film has two surfaces and pulls with 2γ. Default 0.25.
   */
  foamOptionMacro(SurfaceTension, double);
  ///@}

  ///@{
  /**
   * How far the boundary films of the initial mesh stand out from the outermost points, cm; 0, the
   * default, stands for 1.5 mean spacings.
   */
  foamOptionMacro(FinSize, double);
  ///@}

  ///@{
  /**
   * Whether to bring the foam to equilibrium (default), or to show the initial mesh.
   */
  vtkSetMacro(Equilibrate, bool);
  vtkGetMacro(Equilibrate, bool);
  vtkBooleanMacro(Equilibrate, bool);
  ///@}

protected:
  vtkFoamFromPoints();
  ~vtkFoamFromPoints() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                          vtkInformationVector* outputs) override;
  void MakeFoam(vtkInformation* request, vtkInformationVector** inputs,
                vtkInformationVector* outputs) override;

private:
  vtkFoamFromPoints(const vtkFoamFromPoints&) = delete;
  void operator=(const vtkFoamFromPoints&) = delete;

#ifndef __VTK_WRAP__
  void WarnIfScaled(const foam::Foam& foam, const foam::BuildOptions& options);
#endif

  double PeriodicBounds[4] = {0, 0, 0, 0};
  double PeriodVectors[4] = {0, 0, 0, 0};
  double ContainerBounds[4] = {0, 0, 0, 0};
  std::string TargetAreaArray;
  bool Equilibrate = true;
#ifndef __VTK_WRAP__
  std::unique_ptr<foam::BuildOptions> Options;
  std::unique_ptr<foam::ContainerOptions> Walls;
#endif
};

#endif
