// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamEquilibratingAlgorithm
 * @brief What the filters that bring a foam to equilibrium have in common.
 *
 * Holds the properties of the equilibrator and the two outputs: port 0 the films, which carry the
 * whole state of the foam, port 1 the bubbles. Units are cm, s and N.
 *
 * Publication: B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex Model, University
 * of Copenhagen, 2010.
 *
 * @sa vtkFoamFromPoints vtkFoamCoarsen vtkFoamEvolverReader
 */
#ifndef vtkFoamEquilibratingAlgorithm_h
#define vtkFoamEquilibratingAlgorithm_h

#include <memory> // for the options

#include "OptionMacros.h"
#include "vtkFoamFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#ifndef __VTK_WRAP__
namespace foam {
struct EquilibratorOptions;
struct Foam;
struct SampledFoam;
} // namespace foam
#endif

class VTKFOAMFILTERS_EXPORT vtkFoamEquilibratingAlgorithm : public vtkPolyDataAlgorithm {
public:
  vtkTypeMacro(vtkFoamEquilibratingAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EquilibratorType { Newton = 0, Junction = 1 };
  enum DeviceType { Auto = 0, CPU = 1, CUDA = 2 };
  enum LinearSolverType { Iterative = 0, Direct = 1 };
  enum SweepType { Jacobi = 0, GaussSeidel = 1 };
  enum RootSearchType { Angles = 0, Energies = 1 };
  enum EnergyTargetType { Zero = 0, Straight = 1 };

  ///@{
  /**
   * Largest distance between an arc and the polyline that stands for it, cm. 0, the default,
   * stands for 1/200 of the mean spacing of the bubbles. Only the looks depend on it.
   */
  vtkSetMacro(ChordError, double);
  vtkGetMacro(ChordError, double);
  ///@}

  ///@{
  /**
   * How equilibrium is found: Newton (default) solves for all junctions, arcs and pressures at
   * once, to machine precision; Junction is the thesis's own method, junction by junction.
   */
  foamChoiceMacro(Equilibrator, Newton, Junction);
  ///@}

  ///@{
  /**
   * Where it is computed: Auto (default), CPU or CUDA.
   */
  foamChoiceMacro(Device, Auto, CUDA);
  ///@}

  ///@{
  /**
   * Newton: largest dimensionless residual of an equilibrium, > 0. Default 1e-9. Below 1e-11
   * iterations also end, as converged, where rounding lets them get no nearer.
   */
  foamOptionMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Iterations after which a foam is given up as not converged, > 0. Default 256.
   */
  foamOptionMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * Newton with Device CUDA: how its systems of equations are solved, by MINRES (Iterative,
   * default) or by a sparse factorisation (Direct, in a build with cuDSS).
   */
  foamChoiceMacro(LinearSolver, Iterative, Direct);
  ///@}

  ///@{
  /**
   * Junction: whether all junctions move at once (Jacobi, default) or one after the other
   * (GaussSeidel).
   */
  foamChoiceMacro(Sweep, Jacobi, GaussSeidel);
  ///@}

  ///@{
  /**
   * Junction: what a junction seeks besides the areas of its bubbles: 120° between its films
   * (Angles, default) or target energies for them (Energies, proposed in the thesis's 7.1.1).
   */
  foamChoiceMacro(RootSearch, Angles, Energies);
  ///@}

  ///@{
  /**
   * Junction with Energies: target energies of the films, Zero (default) or those of straight films
   * from the point where their sum is least (Straight).
   */
  foamChoiceMacro(EnergyTarget, Zero, Straight);
  ///@}

  ///@{
  /**
   * Junction: the Energy Decay Constraint (thesis 3.5.2). Default on.
   */
  foamOptionMacro(EnergyDecay, bool);
  vtkBooleanMacro(EnergyDecay, bool);
  ///@}

  ///@{
  /**
   * Junction: the Orientation Invariant Constraint (thesis 3.5.1). Default off.
   */
  foamOptionMacro(OrientationInvariant, bool);
  vtkBooleanMacro(OrientationInvariant, bool);
  ///@}

  ///@{
  /**
   * Junction: damping τ of a step. Default 0.1.
   */
  foamOptionMacro(Damping, double);
  ///@}

  ///@{
  /**
   * Junction: step h of the finite differences, relative. Default 0.01.
   */
  foamOptionMacro(FiniteDifferenceStep, double);
  ///@}

  ///@{
  /**
   * Junction: δ_error, below which a junction's Jacobian counts as good. Default 1.
   */
  foamOptionMacro(JacobianTolerance, double);
  ///@}

  ///@{
  /**
   * Junction: change of pressure below which a bubble is at rest, N/cm². Default 0.001.
   */
  foamOptionMacro(PressureTolerance, double);
  ///@}

  ///@{
  /**
   * Junction: move below which a junction is at rest, cm. Default 0.001.
   */
  foamOptionMacro(PositionTolerance, double);
  ///@}

  ///@{
  /**
   * Junction: smallest scale of a step. Default 1e-5.
   */
  foamOptionMacro(MinimumScale, double);
  ///@}

protected:
  vtkFoamEquilibratingAlgorithm();
  ~vtkFoamEquilibratingAlgorithm() override;

  /// Makes the foam for the first piece and leaves the others empty. An error is told and leaves
  /// the outputs empty.
  ///
  /// \returns 1, also after an error: 0 would have the executive add an error of its own, and ask
  /// again at every render.
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  /// Makes the foam that is asked for and writes it to the outputs.
  /// \throws std::exception with what is wrong with the input or the properties.
  virtual void MakeFoam(vtkInformation* request, vtkInformationVector** inputs,
                        vtkInformationVector* outputs) = 0;

#ifndef __VTK_WRAP__
  const foam::EquilibratorOptions& GetEquilibratorOptions() const {
    return *this->Options;
  }

  /// Brings a foam to equilibrium, if it is to be, reporting progress; warns if that fails, and
  /// leaves what there is of it when aborted.
  /// \throws std::exception for properties of the equilibrator that are out of range, in any case
  void BringToEquilibrium(foam::Foam& foam, bool equilibrate);

  /// Writes a foam to the two outputs.
  void WriteOutputs(const foam::SampledFoam& sampled, vtkInformationVector* outputs);
#endif

  /// To be asked often during long work: reports progress now and then, which gives observers the
  /// chance to abort. \returns whether to stop.
  bool PollAbort(double progress);

private:
  vtkFoamEquilibratingAlgorithm(const vtkFoamEquilibratingAlgorithm&) = delete;
  void operator=(const vtkFoamEquilibratingAlgorithm&) = delete;

  void CheckOutputProperties() const;
  void ClearOutputs(vtkInformationVector* outputs);

  double ChordError = 0;
  double LastPoll = 0;
#ifndef __VTK_WRAP__
  std::unique_ptr<foam::EquilibratorOptions> Options;
#endif
};

#endif
