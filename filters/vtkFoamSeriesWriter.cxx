// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamSeriesWriter.h"

#include <exception>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
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

  std::vector<double> Times;
  std::size_t Next = 0;
  std::optional<foam::filters::FrameSeries> Series;
};

vtkFoamSeriesWriter::vtkFoamSeriesWriter() : Present(std::make_unique<Loop>()) {}

vtkFoamSeriesWriter::~vtkFoamSeriesWriter() = default;

int vtkFoamSeriesWriter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkFoamSeriesWriter::Write() {
  this->SetErrorCode(vtkErrorCode::NoError);
  this->SetAbortExecute(0); // what ended an earlier series
  *this->Present = {};
  return this->Superclass::Write() && this->GetErrorCode() == vtkErrorCode::NoError;
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
  if (request->Has(SDDP::REQUEST_UPDATE_EXTENT())) {
    if (loop.Next < loop.Times.size()) {
      input->Set(SDDP::UPDATE_TIME_STEP(), loop.Times[loop.Next]);
    }
    input->Set(SDDP::UPDATE_PIECE_NUMBER(), this->Piece);
    input->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), this->NumberOfPieces);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkFoamSeriesWriter::RequestData(vtkInformation* request, vtkInformationVector**,
                                     vtkInformationVector*) {
  auto& loop = *this->Present;
  this->WriteData();
  ++loop.Next;
  const bool stopped = this->GetAbortExecute() || this->GetErrorCode() != vtkErrorCode::NoError;
  if (loop.Next < loop.Times.size() && !stopped) {
    this->UpdateProgress(static_cast<double>(loop.Next) / static_cast<double>(loop.Times.size()));
    request->Set(SDDP::CONTINUE_EXECUTING(), 1);
  } else {
    request->Remove(SDDP::CONTINUE_EXECUTING());
  }
  return 1;
}

void vtkFoamSeriesWriter::WriteData() {
  if (this->Piece != 0) {
    return;
  }
  auto& loop = *this->Present;
  try {
    auto* frame = vtkPolyData::SafeDownCast(this->GetInput());
    if (!frame || frame->GetNumberOfCells() == 0) {
      foam::filters::fail("there is no foam to write to ", this->FileName);
    }
    const double time = TimeOf(frame);
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
  } catch (const std::system_error& error) {
    this->SetErrorCode(static_cast<unsigned long>(error.code().value()));
    vtkErrorMacro(<< error.what());
  } catch (const std::exception& error) {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< error.what());
  }
}

void vtkFoamSeriesWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n"
     << indent << "WriteTimeSteps: " << this->WriteTimeSteps << "\n"
     << indent << "Append: " << this->Append << "\n"
     << indent << "Piece: " << this->Piece << "\n"
     << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
}
