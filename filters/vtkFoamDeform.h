// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamDeform
 * @brief Deforms a foam quasi-statically, from one T1 to the next.
 *
 * A torus is strained by its periods: with every step of strain its cell is sheared, or stretched,
 * and all of the foam with it, and then it relaxes to the equilibrium that its bubbles' areas have
 * there. Between T1s the equilibrium's response to the strain says at which strain the next film
 * vanishes; the foam is brought to that strain, whatever the frames are, and swaps the film.
 *
 * Frames are times t₀, t₀ + |StrainStep|, …: the strain that has been accumulated, whose rate has
 * no meaning. The strain itself is the films' field data Strain. See vtkFoamEvolutionAlgorithm for
 * input, frames, outputs, and what happens where a run ends.
 *
 * @sa vtkFoamFromPoints vtkFoamCoarsen vtkFoamStatistics
 */
#ifndef vtkFoamDeform_h
#define vtkFoamDeform_h

#include <memory> // for the options

#include "vtkFoamEvolutionAlgorithm.h"

#ifndef __VTK_WRAP__
namespace foam {
struct DeformationOptions;
} // namespace foam
#endif

class VTKFOAMFILTERS_EXPORT vtkFoamDeform : public vtkFoamEvolutionAlgorithm {
public:
  static vtkFoamDeform* New();
  vtkTypeMacro(vtkFoamDeform, vtkFoamEvolutionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DeformationType { SimpleShear = 0, PureShear = 1 };

  ///@{
  /**
   * SimpleShear (default): rows along x slide over each other, F = [1 γ; 0 1]. PureShear: x is
   * stretched and y compressed, F = diag(exp γ, exp −γ).
   */
  foamChoiceMacro(Deformation, SimpleShear, PureShear);
  ///@}

  ///@{
  /**
   * By how much the strain γ grows from frame to frame; below 0 it goes the other way. Not 0.
   * Default 0.01.
   */
  foamOptionMacro(StrainStep, double);
  ///@}

  ///@{
  /**
   * Above 0 the strain goes to and fro between plus and minus this, and is at least |StrainStep|;
   * 0, the default, lets it grow steadily.
   */
  foamOptionMacro(Amplitude, double);
  ///@}

protected:
  vtkFoamDeform();
  ~vtkFoamDeform() override;

#ifndef __VTK_WRAP__
  foam::EvolutionOptions GetEvolutionOptions() const override;
  double GetAskedTimeStep() const override;
#endif

private:
  vtkFoamDeform(const vtkFoamDeform&) = delete;
  void operator=(const vtkFoamDeform&) = delete;

#ifndef __VTK_WRAP__
  std::unique_ptr<foam::DeformationOptions> Options;
#endif
};

#endif
