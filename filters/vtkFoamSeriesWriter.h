// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamSeriesWriter
 * @brief Writes films or bubbles as a time series, frame by frame as they are computed.
 *
 * NAME.pvd lists the times (s), to their last digit, and the files, NAME/NAME_0000.vtp and so on.
 * A file is written under another name and gets its own once all of it lies on the disk, and only
 * then is it listed: whatever happens, what has its name is whole. The series can be read while it
 * grows. After an error, or when its input stops, a series keeps the frames that it has, and can be
 * continued from the last of them.
 *
 * A series that is there already, the input's own perhaps, is replaced once all of the new one is
 * there: until then .unfinished-NAME.pvd lists that, and after an error nothing has changed. One
 * that is continued lists the new frames from when they take the place of those given up. No file
 * is overwritten.
 *
 * A time step that has no foam is left out, with a warning. Where the last has none, as from an
 * input that failed, a series that is there already is not replaced, and that is an error.
 *
 * Of several processes the first writes, the pieces of all.
 *
 * @sa vtkFoamCoarsen vtkXMLPolyDataWriter
 */
#ifndef vtkFoamSeriesWriter_h
#define vtkFoamSeriesWriter_h

#include <memory> // for the series

#include "vtkFoamFiltersModule.h" // for the export macro
#include "vtkFoamWriter.h"

class VTKFOAMFILTERS_EXPORT vtkFoamSeriesWriter : public vtkFoamWriter {
public:
  static vtkFoamSeriesWriter* New();
  vtkTypeMacro(vtkFoamSeriesWriter, vtkFoamWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to write all time steps of the input, one after the other, or the present one alone.
   * Default on.
   */
  vtkSetMacro(WriteTimeSteps, bool);
  vtkGetMacro(WriteTimeSteps, bool);
  vtkBooleanMacro(WriteTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Whether to continue the series that is there: its frames before the first new time are kept.
   * Off, the default, it is replaced.
   */
  vtkSetMacro(Append, bool);
  vtkGetMacro(Append, bool);
  vtkBooleanMacro(Append, bool);
  ///@}

  /**
   * Writes. \returns 1, or 0 after an error, with GetErrorCode() its cause: an errno or one of
   * vtkErrorCode.
   */
  int Write() override;

protected:
  vtkFoamSeriesWriter();
  ~vtkFoamSeriesWriter() override;

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
                             vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;
  void WriteData() override;

private:
  vtkFoamSeriesWriter(const vtkFoamSeriesWriter&) = delete;
  void operator=(const vtkFoamSeriesWriter&) = delete;

  struct Loop;

  void WriteFrame(vtkPolyData* frame);
  void FinishSeries();

  bool WriteTimeSteps = true;
  bool Append = false;
  std::unique_ptr<Loop> Present;
};

#endif
