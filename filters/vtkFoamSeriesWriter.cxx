// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamSeriesWriter.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLPolyDataWriter.h"

#include "FilmReading.h"
#include "FrameSeries.h"
#include "Message.h"

vtkStandardNewMacro(vtkFoamSeriesWriter);

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace {

/// The time of a data set, s.
double TimeOf(vtkPolyData* data) {
  vtkInformation* information = data->GetInformation();
  const auto key = vtkDataObject::DATA_TIME_STEP();
  return information->Has(key) ? information->Get(key) : foam::filters::read_time(data);
}

/// The content of a .vtp file.
std::string Vtp(vtkPolyData* data) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetCompressionLevel(1); // as small within a few percent, and faster
  writer->EncodeAppendedDataOff();
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

} // namespace

/// The time steps that are to be written, and how far that is.
struct vtkFoamSeriesWriter::Loop {
  /// Whether the input shows an earlier frame than the one asked for, as one does that was stopped.
  bool Behind(double time) const {
    return Next > 0 && Next < Times.size() && time < (Times[Next - 1] + Times[Next]) / 2;
  }

  /// Whether nothing is left to be written.
  bool Done() const { return Next >= std::max<std::size_t>(1, Times.size()); }

  std::vector<double> Times;
  std::size_t Next = 0;
  std::size_t Empty = 0; ///< steps without a foam so far
  double FirstEmpty = 0; ///< time of the first, s
  bool LastEmpty = false;
  std::optional<foam::filters::FrameSeries> Series;
};

vtkFoamSeriesWriter::vtkFoamSeriesWriter() : Present(std::make_unique<Loop>()) {}

vtkFoamSeriesWriter::~vtkFoamSeriesWriter() = default;

int vtkFoamSeriesWriter::Write() {
  this->SetAbortExecute(0); // what ended an earlier series
  *this->Present = {};
  const int written = this->Superclass::Write();
  this->FinishSeries();
  return written && this->GetErrorCode() == vtkErrorCode::NoError;
}

vtkTypeBool vtkFoamSeriesWriter::ProcessRequest(vtkInformation* request,
                                                vtkInformationVector** inputs,
                                                vtkInformationVector* outputs) {
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  auto& loop = *this->Present;
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION())) {
    const int count = this->WriteTimeSteps ? input->Length(SDDP::TIME_STEPS()) : 0;
    const double* times = count > 0 ? input->Get(SDDP::TIME_STEPS()) : nullptr;
    loop.Times.assign(times, times + count);
    return 1;
  }
  if (request->Has(SDDP::REQUEST_UPDATE_EXTENT()) && loop.Next < loop.Times.size()) {
    input->Set(SDDP::UPDATE_TIME_STEP(), loop.Times[loop.Next]);
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkFoamSeriesWriter::RequestData(vtkInformation* request, vtkInformationVector**,
                                     vtkInformationVector*) {
  auto& loop = *this->Present;
  this->WriteData();
  const bool stopped = this->GetAbortExecute() || this->GetErrorCode() != vtkErrorCode::NoError;
  loop.Next += stopped ? 0 : 1;
  int goOn = !stopped && !loop.Done();
  if (this->IsOneOfSeveral()) {
    this->Controller->Broadcast(&goOn, 1, 0); // what the first can know alone
  }
  if (goOn) {
    this->UpdateProgress(static_cast<double>(loop.Next) / static_cast<double>(loop.Times.size()));
    request->Set(SDDP::CONTINUE_EXECUTING(), 1);
  } else {
    request->Remove(SDDP::CONTINUE_EXECUTING());
  }
  return 1;
}

void vtkFoamSeriesWriter::WriteData() {
  const vtkSmartPointer<vtkPolyData> frame = this->WholeInput();
  if (this->Piece == 0) {
    this->Try([&] { this->WriteFrame(frame); });
  }
}

/// \throws FoamError if the input is no vtkPolyData
void vtkFoamSeriesWriter::WriteFrame(vtkPolyData* frame) {
  auto* const input = vtkPolyData::SafeDownCast(this->GetInput());
  if (!input) {
    foam::filters::fail("the input is a ", this->GetInput()->GetClassName(),
                        "; what is wanted are films or bubbles, an output of FoamFromPoints or "
                        "FoamCoarsen or a file of one");
  }
  auto& loop = *this->Present;
  loop.LastEmpty = !frame || frame->GetNumberOfCells() == 0;
  if (loop.LastEmpty) {
    if (loop.Empty++ == 0 && loop.Next < loop.Times.size()) {
      loop.FirstEmpty = loop.Times[loop.Next];
    }
    return;
  }
  const double time = TimeOf(input->GetNumberOfCells() > 0 ? input : frame);
  if (loop.Behind(time)) {
    if (foam::filters::read_end(frame).empty()) {
      this->SetAbortExecute(1);
    } else { // what was written last was the last, and says so now
      loop.Series->replace_last(Vtp(frame));
      loop.Next = loop.Times.size();
    }
    return;
  }
  if (!loop.Series) {
    loop.Series.emplace(this->FileName, time, this->Append);
  }
  loop.Series->add(time, Vtp(frame));
}

void vtkFoamSeriesWriter::FinishSeries() {
  auto& loop = *this->Present;
  this->Try([&] {
    if (!loop.Series) {
      if (loop.Empty > 0) {
        foam::filters::fail("there is no foam to write to ", this->FileName);
      }
      return;
    }
    const std::string left_out = foam::filters::message(
        loop.Empty, " of ", loop.Times.size(), " time steps have no foam, the first at ",
        loop.FirstEmpty, " s: they are left out of ", this->FileName);
    // Where the last has none, the input may have failed.
    const bool whole = loop.Done() && !loop.LastEmpty;
    if (loop.Empty > 0 && !whole && loop.Series->waits()) {
      this->SetErrorCode(vtkErrorCode::PrematureEndOfFileError);
      vtkErrorMacro(<< left_out);
    } else if (loop.Empty > 0) {
      vtkWarningMacro(<< left_out);
    }
    if (!loop.Series->finish(whole)) {
      vtkWarningMacro(<< this->FileName << " is as it was, because not all of what is to replace it"
                      << " was written: " << loop.Series->unfinished_index().string()
                      << " lists what was.");
    }
  });
  loop.Series.reset();
}

void vtkFoamSeriesWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WriteTimeSteps: " << this->WriteTimeSteps << "\n"
     << indent << "Append: " << this->Append << "\n";
}
