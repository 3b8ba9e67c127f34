// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkFoamWriter
 * @brief What writers of films or bubbles have in common.
 *
 * Of several processes that have a part each, the first writes what all have. What goes wrong is
 * told, and GetErrorCode() is its cause: an errno or one of vtkErrorCode.
 *
 * @sa vtkFoamSeriesWriter vtkFoamEvolverWriter
 */
#ifndef vtkFoamWriter_h
#define vtkFoamWriter_h

#include <functional> // for what may go wrong
#include <string>     // for the name of the file

#include "vtkFoamFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"      // for the controller
#include "vtkWriter.h"

class vtkMultiProcessController;
class vtkPolyData;

class VTKFOAMFILTERS_EXPORT vtkFoamWriter : public vtkWriter {
public:
  vtkAbstractTypeMacro(vtkFoamWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  ///@{
  /**
   * The piece of this process, of NumberOfPieces. Default 0 of 1.
   */
  vtkSetMacro(Piece, int);
  vtkGetMacro(Piece, int);
  vtkSetMacro(NumberOfPieces, int);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

  ///@{
  /**
   * The processes that share the pieces. Default: the global controller.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /**
   * Writes. \returns 1, or 0 after an error, with GetErrorCode() its cause.
   */
  int Write() override;

protected:
  vtkFoamWriter();
  ~vtkFoamWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
                             vtkInformationVector* outputs) override;

#ifndef __VTK_WRAP__
  bool IsOneOfSeveral() const;
  /// The input, with what other processes have of it, in the first; null in others, and for what is
  /// no vtkPolyData.
  vtkSmartPointer<vtkPolyData> WholeInput();
  /// Does something, and tells of what goes wrong.
  void Try(const std::function<void()>& action);
#endif

  std::string FileName;
  int Piece = 0;
  int NumberOfPieces = 1;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  vtkFoamWriter(const vtkFoamWriter&) = delete;
  void operator=(const vtkFoamWriter&) = delete;
};

#endif
