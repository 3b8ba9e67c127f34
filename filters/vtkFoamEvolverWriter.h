// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamEvolverWriter
 * @brief Writes films as a datafile (.fe) for Surface Evolver.
 *
 * The file is one of the two-dimensional STRING model with a quadratic edge for each film, whose
 * methods circular_arc_length and circular_arc_area give Surface Evolver the energy, areas and
 * pressures that the foam has here. Bodies have the attribute BubbleId. Walls are edges
 * without tension on constraints. The file is there whole or not at all. Of several processes the
 * first writes what all have.
 *
 * @sa vtkFoamEvolverReader vtkFoamSeriesWriter
 */
#ifndef vtkFoamEvolverWriter_h
#define vtkFoamEvolverWriter_h

#include "vtkFoamFiltersModule.h" // for the export macro
#include "vtkFoamWriter.h"

class VTKFOAMFILTERS_EXPORT vtkFoamEvolverWriter : public vtkFoamWriter {
public:
  static vtkFoamEvolverWriter* New();
  vtkTypeMacro(vtkFoamEvolverWriter, vtkFoamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkFoamEvolverWriter();
  ~vtkFoamEvolverWriter() override;

  void WriteData() override;

private:
  vtkFoamEvolverWriter(const vtkFoamEvolverWriter&) = delete;
  void operator=(const vtkFoamEvolverWriter&) = delete;
};

#endif
