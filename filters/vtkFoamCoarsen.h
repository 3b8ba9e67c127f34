// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamCoarsen
 * @brief Lets a foam coarsen: gas diffuses through the films, films swap, bubbles vanish.
 *
 * A temporal filter. It offers frames 0 … NumberOfFrames as time steps t₀, t₀ + Δt, …, where t₀ is
 * the time that its input carries, and shows the frame that was asked for: the last one that is not
 * later than the requested time. Going forward advances the simulation; going back, or jumping,
 * starts from the nearest keyframe before and replays, with the same bits.
 *
 * Input: films, of vtkFoamFromPoints, of this filter, or read back from a .vtp. Of a temporal input
 * one time step is taken, the last or the first. A run that begins with the films of a keyframe
 * continues with the bits of the uninterrupted run; from any other frame it continues to within the
 * tolerance. What films say of their equilibrium is measured: where it does not hold, because they
 * were transformed, say, there is a warning, and Converged = 0. On a torus and in a container
 * target areas of such films that do not fill it are scaled by up to 1 %, with a warning; more is
 * an error.
 *
 * Output port 0, films, and port 1, bubbles, are those of vtkFoamFromPoints. A frame that did not
 * reach equilibrium is warned about and has Converged = 0. When a bubble would vanish that
 * cannot, as one of the last two, or no equilibrium is found, the run ends with a warning. The
 * frame of the end has the field data Ended = 1 and EndReason, what stands in the way; from then on
 * it is the last that is offered, and what later times show.
 *
 * A request that is aborted, or that an error ends, shows the last frame that was complete; the
 * next request goes on from there.
 *
 * Publication: B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex Model, University
 * of Copenhagen, 2010.
 *
 * @sa vtkFoamFromPoints vtkFoamStatistics
 */
#ifndef vtkFoamCoarsen_h
#define vtkFoamCoarsen_h

#include <memory>   // for the options and the simulation
#include <optional> // for the end of a run

#include "vtkFoamEquilibratingAlgorithm.h"

class vtkInformationDataObjectMetaDataKey;
class vtkPolyData;

#ifndef __VTK_WRAP__
namespace foam {
struct EquilibriumReport;
struct Foam;
} // namespace foam
#endif

class VTKFOAMFILTERS_EXPORT vtkFoamCoarsen : public vtkFoamEquilibratingAlgorithm {
public:
  static vtkFoamCoarsen* New();
  vtkTypeMacro(vtkFoamCoarsen, vtkFoamEquilibratingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum StartFromType { First = 0, Last = 1 };
  enum TargetAreasType { FromFilms = 0, Measured = 1 };
  enum ThresholdsType { Absolute = 0, Relative = 1, Automatic = 2 };
  enum TwoSidedBubblesType { Remove = 0, Slide = 1 };
  enum SteppingType { Events = 0, FixedSteps = 1 };
  enum TopologicalAlgorithmType { Final = 0, Original = 1, Improved = 2, Simultaneous = 3 };

  ///@{
  /**
   * The time step of a temporal input that the run begins with, Last (default) or First. The last
   * of an input that is another FoamCoarsen is the end of its run, which is computed when the first
   * frame is asked for, and not before.
   */
  vtkSetClampMacro(StartFrom, int, First, Last);
  vtkGetMacro(StartFrom, int);
  ///@}

  /**
   * The time that the run begins with, s: the one that the input's data carry. Known from
   * UpdateInformation on or, where the input is a run that is still to be computed, from Update.
   */
  vtkGetMacro(StartTime, double);

  /**
   * In the information of what computes its time steps one after the other, and of filters after
   * it: a data object with the field data TimeStep, s. Who reads it knows that the last time step
   * costs all of a run, and can announce times without it.
   */
  static vtkInformationDataObjectMetaDataKey* RUN();

  ///@{
  /**
   * Whether the target areas are those that the films carry (FromFilms, default), or the areas that
   * their bubbles have (Measured). With these, pressures are scaled to go with the films' arcs, so
   * that a foam that was scaled goes on as the same foam.
   */
  vtkSetClampMacro(TargetAreas, int, FromFilms, Measured);
  vtkGetMacro(TargetAreas, int);
  ///@}

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
   * Number of frames after the first. Default 300.
   */
  vtkSetMacro(NumberOfFrames, int);
  vtkGetMacro(NumberOfFrames, int);
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

  ///@{
  /**
   * A keyframe every so many frames, ≥ 1: there the solver keeps nothing from before, and a run can
   * be resumed with the same bits. Default 10.
   */
  foamOptionMacro(KeyframeInterval, int);
  ///@}

  ///@{
  /**
   * Memory for keyframes, MiB; when it is full, every other keyframe is dropped. Frames are the
   * same with any. Default 256.
   */
  vtkSetMacro(KeyframeMemory, int);
  vtkGetMacro(KeyframeMemory, int);
  ///@}

protected:
  vtkFoamCoarsen();
  ~vtkFoamCoarsen() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                          vtkInformationVector* outputs) override;
  void MakeFoam(vtkInformation* request, vtkInformationVector** inputs,
                vtkInformationVector* outputs) override;

private:
  vtkFoamCoarsen(const vtkFoamCoarsen&) = delete;
  void operator=(const vtkFoamCoarsen&) = delete;

  struct Settings;
  struct Simulation;
  struct Start;

  Settings GetSettings() const;
  void RequestStart(vtkInformation* input) const;
  bool RunIsOf(const Settings& settings, vtkPolyData* input) const;
  void AnnounceRun(vtkInformationVector* outputs);
  void PrepareSimulation(vtkInformationVector** inputs);
#ifndef __VTK_WRAP__
  void Announce(double start, double timeStep, const std::optional<int>& end,
                vtkInformationVector* outputs);
  foam::EquilibriumReport OfMeasuredTargets(foam::EquilibriumReport said, const foam::Foam& foam);
#endif
  void AdvanceTo(int frame);
  void WarnIfNotConverged();
  void WarnOfLargeThresholds();
  double ReadTimeStep(vtkPolyData* input);
  const Start& ReadStart(vtkPolyData* input);

  int StartFrom = Last;
  double StartTime = 0;
  int TargetAreas = FromFilms;
  int NumberOfFrames = 300;
  int KeyframeMemory = 256;
  std::unique_ptr<Settings> Options;
  std::unique_ptr<Start> Next; ///< what has been read and not been run yet
  std::unique_ptr<Simulation> Run;
};

#endif
