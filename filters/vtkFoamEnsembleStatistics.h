// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamEnsembleStatistics
 * @brief What many independent runs say about a foam: means and their confidence intervals.
 *
 * Input: a partitioned data set with a partition for each run, which is either its films or a
 * table. Films are measured as vtkFoamStatistics does. A table has one row, whose columns are
 * quantities, or a row per number of sides with the column Sides, such as vtkFoamStatistics'
 * BySides. Partitions may be spread over processes: they are pooled through the controller, and the
 * first process has the result. Empty partitions are none.
 *
 * Output: a table with a row for each quantity: Quantity, its name; Sides, the number of sides that
 * it is for, or 0 for the whole foam; Members, the number of runs that know it; Mean; StandardError
 * of the mean; Lower95 and Upper95, the ends of its 95 % confidence interval by Student's t. They
 * have the unit of the quantity, and are NaN where one run alone knows it. Of bubbles with a number
 * of sides that a run does not have, its Count and Fraction are 0; values that are not finite are
 * left out.
 *
 * Publication: Student, The probable error of a mean, Biometrika 6, 1 (1908).
 *
 * @sa vtkFoamStatistics vtkPartitionedDataSet vtkMultiProcessController
 */
#ifndef vtkFoamEnsembleStatistics_h
#define vtkFoamEnsembleStatistics_h

#include "vtkFoamFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"      // for the controller
#include "vtkTableAlgorithm.h"

class vtkMultiProcessController;

class VTKFOAMFILTERS_EXPORT vtkFoamEnsembleStatistics : public vtkTableAlgorithm {
public:
  static vtkFoamEnsembleStatistics* New();
  vtkTypeMacro(vtkFoamEnsembleStatistics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether bubbles that touch the world count in the averages over films. Default off.
   */
  vtkSetMacro(IncludeBoundary, bool);
  vtkGetMacro(IncludeBoundary, bool);
  vtkBooleanMacro(IncludeBoundary, bool);
  ///@}

  ///@{
  /**
   * The processes whose partitions are pooled; null for this one alone. Default: the global
   * controller.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkFoamEnsembleStatistics();
  ~vtkFoamEnsembleStatistics() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkFoamEnsembleStatistics(const vtkFoamEnsembleStatistics&) = delete;
  void operator=(const vtkFoamEnsembleStatistics&) = delete;

  bool IncludeBoundary = false;
  vtkSmartPointer<vtkMultiProcessController> Controller;
};

#endif
