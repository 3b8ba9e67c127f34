// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a pipeline asks of a filter, and a filter of its input.
#pragma once

#include <algorithm>

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace foam::filters {

/// The output that a request came through.
inline vtkInformation* requested_output(vtkInformation* request, vtkInformationVector* outputs) {
  const int port = request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT());
  return outputs->GetInformationObject(std::max(0, port));
}

/// Whether the first piece is asked for. A foam is one whole: of several processes the first has
/// all of it and the others have nothing.
inline bool is_first_piece(vtkInformation* request, vtkInformationVector* outputs) {
  const auto key = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  vtkInformation* output = requested_output(request, outputs);
  return !output->Has(key) || output->Get(key) <= 0;
}

/// Asks an input for all of its data.
inline void request_whole(vtkInformation* input) {
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
}

} // namespace foam::filters
