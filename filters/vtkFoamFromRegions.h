// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamFromRegions
 * @brief What the filters that make a foam of regions have in common: the foam has the regions'
 * neighbours and areas.
 *
 * Output port 0 are films and port 1 bubbles, as those of vtkFoamFromPoints. Films have the cell
 * array ArcMisfit (cm): how far the points of the line between two regions lie from the arc that
 * stands for it before the foam is brought to equilibrium. Their field data have FourFoldPoints,
 * the number of points in which more than three regions meet, which become several junctions.
 *
 * @sa vtkFoamFromPolygons vtkFoamFromLabels vtkFoamFromPoints
 */
#ifndef vtkFoamFromRegions_h
#define vtkFoamFromRegions_h

#include "vtkFoamEquilibratingAlgorithm.h"

#ifndef __VTK_WRAP__
namespace foam {
struct DivisionFoam;
} // namespace foam
#endif

class VTKFOAMFILTERS_EXPORT vtkFoamFromRegions : public vtkFoamEquilibratingAlgorithm {
public:
  vtkTypeMacro(vtkFoamFromRegions, vtkFoamEquilibratingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Surface tension γ, N/cm, > 0; a film has two surfaces and pulls with 2γ. Default 0.25.
   */
  vtkSetMacro(SurfaceTension, double);
  vtkGetMacro(SurfaceTension, double);
  ///@}

  ///@{
  /**
   * Whether to bring the foam to equilibrium (default), or to show its films as they fit the lines
   * between regions.
   */
  vtkSetMacro(Equilibrate, bool);
  vtkGetMacro(Equilibrate, bool);
  vtkBooleanMacro(Equilibrate, bool);
  ///@}

protected:
  vtkFoamFromRegions();
  ~vtkFoamFromRegions() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                          vtkInformationVector* outputs) override;

#ifndef __VTK_WRAP__
  /// Brings the foam to equilibrium, if it is to be, and shows it with its report.
  void ShowFoam(foam::DivisionFoam& made, vtkInformationVector* outputs);
#endif

private:
  vtkFoamFromRegions(const vtkFoamFromRegions&) = delete;
  void operator=(const vtkFoamFromRegions&) = delete;

  double SurfaceTension = 0.25;
  bool Equilibrate = true;
};

#endif
