// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamEvolutionAlgorithm
 * @brief What the filters that take a foam from frame to frame have in common.
 *
 * A temporal filter. It offers frames 0 … NumberOfFrames as time steps t₀, t₀ + Δt, …, where t₀ is
 * the time that its input carries, and shows the frame that was asked for: the last one that is not
 * later than the requested time. Going forward advances the foam; going back, or jumping, starts
 * from the nearest keyframe before and replays, with the same bits.
 *
 * Input: films, of vtkFoamFromPoints, of such a filter, or read back from a .vtp. Of a temporal
 * input one time step is taken, the last or the first. A run that begins with the films of a
 * keyframe continues with the bits of the uninterrupted run; from any other frame it continues to
 * within the tolerance. What films say of their equilibrium is measured: where it does not hold,
 * because they were transformed, say, there is a warning, and Converged = 0. On a torus and in a
 * container target areas of such films that do not fill it are scaled by up to 1 %, with a warning;
 * more is an error.
 *
 * Output port 0, films, and port 1, bubbles, are those of vtkFoamFromPoints. Port 2, events, has a
 * vertex for every topological operation from the run's first frame to the one that is shown: its
 * Kind (1, 2, 3 for T1, T2, T3), its Time, the Strain that the foam had, and Bubbles, four
 * BubbleIds: of a T1 those that lost a side and those that gained one, of a T2 or T3 the one that
 * vanished and those that were beside it; −1 stands for an outside, and for none.
 *
 * A frame that did not reach equilibrium is warned about and has Converged = 0. When the foam
 * cannot go on the run ends with a warning. The frame of the end has the field data Ended = 1 and
 * EndReason, what stands in the way; from then on it is the last that is offered, and what later
 * times show.
 *
 * A request that is aborted, or that an error ends, shows the last frame that was complete; the
 * next request goes on from there.
 *
 * @sa vtkFoamCoarsen vtkFoamDeform
 */
#ifndef vtkFoamEvolutionAlgorithm_h
#define vtkFoamEvolutionAlgorithm_h

#include <memory>   // for the run
#include <optional> // for the end of a run

#include "vtkFoamEquilibratingAlgorithm.h"

class vtkInformationDataObjectMetaDataKey;
class vtkPolyData;

#ifndef __VTK_WRAP__
namespace foam {
struct EquilibriumReport;
struct EvolutionOptions;
struct FilmSet;
struct Foam;
} // namespace foam
#endif

class VTKFOAMFILTERS_EXPORT vtkFoamEvolutionAlgorithm : public vtkFoamEquilibratingAlgorithm {
public:
  vtkTypeMacro(vtkFoamEvolutionAlgorithm, vtkFoamEquilibratingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum StartFromType { First = 0, Last = 1 };
  enum TargetAreasType { FromFilms = 0, Measured = 1 };

  ///@{
  /**
   * The time step of a temporal input that the run begins with, Last (default) or First. The last
   * of an input that is such a filter itself is the end of its run, which is computed when the
   * first frame is asked for, and not before.
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
   * Number of frames after the first.
   */
  vtkSetMacro(NumberOfFrames, int);
  vtkGetMacro(NumberOfFrames, int);
  ///@}

  ///@{
  /**
   * A keyframe every so many frames, ≥ 1: there the solver keeps nothing from before, and a run can
   * be resumed with the same bits. Default 10.
   */
  vtkSetMacro(KeyframeInterval, int);
  vtkGetMacro(KeyframeInterval, int);
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
  /// \param numberOfFrames the default
  explicit vtkFoamEvolutionAlgorithm(int numberOfFrames);
  ~vtkFoamEvolutionAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                          vtkInformationVector* outputs) override;
  void MakeFoam(vtkInformation* request, vtkInformationVector** inputs,
                vtkInformationVector* outputs) override;

#ifndef __VTK_WRAP__
  /// What evolves, and how, with the equilibrator's options.
  virtual foam::EvolutionOptions GetEvolutionOptions() const = 0;
  /// The time between two frames, s, as far as the properties say it; 0 for an automatic one.
  virtual double GetAskedTimeStep() const = 0;
  /// The automatic one for a foam. \param meanArea of its bubbles' targets, cm²
  virtual double GetAutomaticTimeStep(const foam::FilmSet& films, double meanArea) const;
  /// Warns of what is odd about the properties beside the foam that a run begins with.
  virtual void WarnOfStart(const foam::Foam& foam);
#endif

private:
  vtkFoamEvolutionAlgorithm(const vtkFoamEvolutionAlgorithm&) = delete;
  void operator=(const vtkFoamEvolutionAlgorithm&) = delete;

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
  double ReadTimeStep(vtkPolyData* input);
  const Start& ReadStart(vtkPolyData* input);

  int StartFrom = Last;
  double StartTime = 0;
  int TargetAreas = FromFilms;
  int NumberOfFrames;
  int KeyframeInterval = 10;
  int KeyframeMemory = 256;
  std::unique_ptr<Start> Next; ///< what has been read and not been run yet
  std::unique_ptr<Simulation> Run;
};

#endif
