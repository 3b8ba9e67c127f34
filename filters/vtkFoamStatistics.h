// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamStatistics
 * @brief A foam in figures: topology, areas, energy.
 *
 * Input: films, of vtkFoamFromPoints, of vtkFoamCoarsen, or read back from a .vtp. Four tables:
 *
 * Port 0, Summary, one row: Time (s), Bubbles, MeanSides, Mu2 (second moment of the number of sides
 * about six), MeanArea (cm²), AreaSecondMoment ⟨A²⟩/⟨A⟩², Energy (N), AboavA (a of Aboav–Weaire's
 * law), StressXX, StressYY, StressXY (N/cm², tension positive), NormalStressDifference (σ_xx −
 * σ_yy), Strain (of FoamDeform), T1Count, T2Count, T3Count, Iterations, MaxAngleError (rad),
 * MaxAreaError (relative). Stress is that of the whole foam; on a torus and in a container
 * pressures have a constant in common that means nothing, and StressXX and StressYY have it too.
 * The two errors are measured: where films say that they are in equilibrium and are not, there is a
 * warning.
 *
 * Port 1, BySides, one row per number of sides n: Sides, Count, Fraction p(n), MeanNeighbourSides
 * m(n), AboavProduct n·m(n), AboavIdeal 5n + 7.4, MeanArea ⟨A_n⟩/⟨A⟩.
 *
 * Port 2, Bubbles, one row per bubble: BubbleId, Area, TargetArea (cm²), Pressure (N/cm²), Sides,
 * Perimeter (cm), OnBoundary, Stress (N/cm²), a symmetric tensor in VTK's order.
 *
 * Port 3, Distribution, p(n) beside a real foam's in the scaling state, one row per n, also where
 * no bubble has n sides: Sides, Fraction, MeasuredFraction (0 where none was measured). The
 * measured foam is that of A. E. Roth, C. D. Jones, D. J. Durian, Phys. Rev. E 87, 042304 (2013).
 *
 * Publication: B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex Model, University
 * of Copenhagen, 2010, section 2.6.
 *
 * @sa vtkFoamCoarsen
 */
#ifndef vtkFoamStatistics_h
#define vtkFoamStatistics_h

#include "vtkFoamFiltersModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

#ifndef __VTK_WRAP__
namespace foam {
struct Foam;
} // namespace foam
#endif

class VTKFOAMFILTERS_EXPORT vtkFoamStatistics : public vtkTableAlgorithm {
public:
  static vtkFoamStatistics* New();
  vtkTypeMacro(vtkFoamStatistics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether bubbles that touch the world count in the averages. Default off. Energy, counts of
   * events and errors are always the whole foam's.
   */
  vtkSetMacro(IncludeBoundary, bool);
  vtkGetMacro(IncludeBoundary, bool);
  vtkBooleanMacro(IncludeBoundary, bool);
  ///@}

  ///@{
  /**
   * Whether Summary has ShearModulus, G = dσ_xy/dγ (N/cm²) of a torus in simple shear along x, at
   * the strain that it has: by one solution of Newton's equations. A foam that is no torus, or not
   * in equilibrium, has none, and is warned about. Default off.
   */
  vtkSetMacro(ShearModulus, bool);
  vtkGetMacro(ShearModulus, bool);
  vtkBooleanMacro(ShearModulus, bool);
  ///@}

protected:
  vtkFoamStatistics();
  ~vtkFoamStatistics() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                          vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkFoamStatistics(const vtkFoamStatistics&) = delete;
  void operator=(const vtkFoamStatistics&) = delete;

#ifndef __VTK_WRAP__
  double MeasureShearModulus(const foam::Foam& foam);
#endif

  bool IncludeBoundary = false;
  bool ShearModulus = false;
};

#endif
