// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamEvolverWriter
 * @brief Writes films as a datafile (.fe) for Surface Evolver.
 *
 * The file is one of the two-dimensional STRING model with a quadratic edge for each film, whose
 * methods circular_arc_length and circular_arc_area give Surface Evolver the energy, areas and
 * pressures that the foam has here. Bodies have the attribute BubbleId. Walls are edges
 * without tension on constraints. The file is there whole or not at all.
 *
 * @sa vtkFoamEvolverReader vtkFoamSeriesWriter
 */
#ifndef vtkFoamEvolverWriter_h
#define vtkFoamEvolverWriter_h

#include <string> // for the name of the file

#include "vtkFoamFiltersModule.h" // for the export macro
#include "vtkWriter.h"

class VTKFOAMFILTERS_EXPORT vtkFoamEvolverWriter : public vtkWriter {
public:
  static vtkFoamEvolverWriter* New();
  vtkTypeMacro(vtkFoamEvolverWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write, NAME.fe.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  /**
   * Writes. \returns 1, or 0 after an error, with GetErrorCode() its cause: an errno or one of
   * vtkErrorCode.
   */
  int Write() override;

protected:
  vtkFoamEvolverWriter();
  ~vtkFoamEvolverWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkFoamEvolverWriter(const vtkFoamEvolverWriter&) = delete;
  void operator=(const vtkFoamEvolverWriter&) = delete;

  std::string FileName;
};

#endif
