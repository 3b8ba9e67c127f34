// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamEvolverReader
 * @brief Reads a two-dimensional foam of Surface Evolver's, a datafile (.fe) or a dump (.dmp).
 *
 * The file is one of the STRING model, free, on a torus that the foam fills or between walls, with
 * straight or quadratic edges. Edges that meet two by two are one film: the arc that has their area
 * beside it. A film pulls with the edge's tension, 1 if the file does not say; bubbles have the
 * VOLUME of their bodies as their target area, and BubbleId is the body's attribute of that name,
 * its ORIGINAL or its number. Lengths are the file's.
 *
 * Edges on a CONSTRAINT or a BOUNDARY, a line or a circle, or FIXED, with one bubble beside them
 * are walls, along which films slide, or on which they are pinned where their vertices are FIXED.
 *
 * What changes a foam in ways that it cannot have here is an error that names line and keyword:
 * other walls, fixed films, bubbles of free area, other energies. Keywords that are not known are
 * skipped with a warning, and commands after READ are not obeyed.
 *
 * Output port 0 are films and port 1 bubbles, as those of vtkFoamFromPoints. The films' field data
 * have ArcMisfit (cm), how far the farthest point of the file lies from the arc that stands for its
 * film.
 *
 * Publication: K. A. Brakke, The Surface Evolver, Experimental Mathematics 1 (1992) 141.
 *
 * @sa vtkFoamEvolverWriter vtkFoamFromPoints
 */
#ifndef vtkFoamEvolverReader_h
#define vtkFoamEvolverReader_h

#include <string> // for the name of the file

#include "vtkFoamEquilibratingAlgorithm.h"

class VTKFOAMFILTERS_EXPORT vtkFoamEvolverReader : public vtkFoamEquilibratingAlgorithm {
public:
  static vtkFoamEvolverReader* New();
  vtkTypeMacro(vtkFoamEvolverReader, vtkFoamEquilibratingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read, .fe or .dmp.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  ///@{
  /**
   * Whether to bring the foam to equilibrium, or to show it as the file has it (default).
   */
  vtkSetMacro(Equilibrate, bool);
  vtkGetMacro(Equilibrate, bool);
  vtkBooleanMacro(Equilibrate, bool);
  ///@}

  /**
   * Whether a file looks like one of Surface Evolver's STRING model.
   */
  static int CanReadFile(const char* fileName);

protected:
  vtkFoamEvolverReader();
  ~vtkFoamEvolverReader() override;

  void MakeFoam(vtkInformation* request, vtkInformationVector** inputs,
                vtkInformationVector* outputs) override;

private:
  vtkFoamEvolverReader(const vtkFoamEvolverReader&) = delete;
  void operator=(const vtkFoamEvolverReader&) = delete;

  std::string FileName;
  bool Equilibrate = false;
};

#endif
