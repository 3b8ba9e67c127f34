// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamCoarsen
 * @brief Lets a foam coarsen: gas diffuses through the films, films swap, bubbles vanish.
 *
 * Frames are times t₀, t₀ + TimeStep, …; when a bubble would vanish that cannot, as one of the last
 * two, or no equilibrium is found, the run ends. See vtkFoamEvolutionAlgorithm for input, frames,
 * outputs, and what happens where a run ends.
 *
 * Publication: B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex Model, University
 * of Copenhagen, 2010.
 *
 * @sa vtkFoamFromPoints vtkFoamDeform vtkFoamStatistics
 */
#ifndef vtkFoamCoarsen_h
#define vtkFoamCoarsen_h

#include <memory> // for the options

#include "vtkFoamEvolutionAlgorithm.h"

#ifndef __VTK_WRAP__
namespace foam {
struct CoarseningOptions;
} // namespace foam
#endif

class VTKFOAMFILTERS_EXPORT vtkFoamCoarsen : public vtkFoamEvolutionAlgorithm {
public:
  static vtkFoamCoarsen* New();
  vtkTypeMacro(vtkFoamCoarsen, vtkFoamEvolutionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ThresholdsType { Absolute = 0, Relative = 1, Automatic = 2 };
  enum TwoSidedBubblesType { Remove = 0, Slide = 1 };
  enum SteppingType { Events = 0, FixedSteps = 1 };
  enum TopologicalAlgorithmType { Final = 0, Original = 1, Improved = 2, Simultaneous = 3 };

  ///@{
  /**
   * Time between two frames, Δt, s. 0, the default, stands for an automatic one: that with which
   * the input has been coarsened already or, of films that have not, the one of which 300 leave
   * about a third of the bubbles, whatever their unit. The one in force is in the films' field
   * data as TimeStep.
   */
  foamOptionMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Permeability κ of the films, the gas that passes per length (cm), pressure (N/cm²) and time
   * (s), ≥ 0. Von Neumann's law: an n-sided bubble grows at (2π/3)γκ(n − 6) cm²/s. Default 1.
   */
  foamOptionMacro(Permeability, double);
  ///@}

  ///@{
  /**
   * Where the thresholds come from. Automatic (default): T1s at a hundredth of √Ā, T2s at a
   * hundredth of Ā, where Ā is the bubbles' mean area, which grows as they coarsen. Absolute: the
   * two values T1Length and T2Area, with a warning if they are not small beside the bubbles.
   * Relative: Weygand's, from Alpha and the foam's own length. Those in force are in the films'
   * field data as T1Length and T2Area.
   */
  foamChoiceMacro(Thresholds, Absolute, Automatic);
  ///@}

  ///@{
  /**
   * Length of a film below which it may swap (T1), cm, ≥ 0. Default 0.025.
   */
  foamOptionMacro(T1Length, double);
  ///@}

  ///@{
  /**
   * Area of a bubble below which it may vanish (T2, T3), cm², ≥ 0. Default 0.05.
   */
  foamOptionMacro(T2Area, double);
  ///@}

  ///@{
  /**
   * Relative thresholds: Weygand's α, > 0. Default 0.05.
   */
  foamOptionMacro(Alpha, double);
  ///@}

  ///@{
  /**
   * What happens to two-sided bubbles: Remove (default), they stay on their film until they vanish
   * (T3); Slide, they slide along it to the nearest corner and become three-sided.
   */
  foamChoiceMacro(TwoSidedBubbles, Remove, Slide);
  ///@}

  ///@{
  /**
   * How Equilibrator Newton goes through time: Events (default), from one topological event to the
   * next, on the CPU alone; FixedSteps, in a frame or equal parts of one with all events of a step
   * at once, on a GPU as well.
   */
  foamChoiceMacro(Stepping, Events, FixedSteps);
  ///@}

  ///@{
  /**
   * The order of the topological operations in a frame of Equilibrator Junction. Final (default)
   * follows every cascade (thesis Figure 4.8); the two after it are there for comparison: Original
   * walks over the junctions once and equilibrates those where nothing gives way (Figure 4.4),
   * Improved goes through bubbles and films in turn until nothing gives way (Figure 4.6).
   * Simultaneous carries out many operations at once, where they do not meet; a GPU computes this
   * one alone.
   */
  foamChoiceMacro(TopologicalAlgorithm, Final, Simultaneous);
  ///@}

protected:
  vtkFoamCoarsen();
  ~vtkFoamCoarsen() override;

#ifndef __VTK_WRAP__
  foam::EvolutionOptions GetEvolutionOptions() const override;
  double GetAskedTimeStep() const override;
  double GetAutomaticTimeStep(const foam::FilmSet& films, double meanArea) const override;
  void WarnOfStart(const foam::Foam& start) override;
#endif

private:
  vtkFoamCoarsen(const vtkFoamCoarsen&) = delete;
  void operator=(const vtkFoamCoarsen&) = delete;

#ifndef __VTK_WRAP__
  std::unique_ptr<foam::CoarseningOptions> Options;
#endif
};

#endif
