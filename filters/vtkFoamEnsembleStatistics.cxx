// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamEnsembleStatistics.h"

#include <exception>
#include <vector>

#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkTable.h"

#include "EnsembleSample.h"
#include "Message.h"

vtkStandardNewMacro(vtkFoamEnsembleStatistics);

vtkFoamEnsembleStatistics::vtkFoamEnsembleStatistics()
    : Controller(vtkMultiProcessController::GetGlobalController()) {}

vtkFoamEnsembleStatistics::~vtkFoamEnsembleStatistics() = default;

void vtkFoamEnsembleStatistics::SetController(vtkMultiProcessController* controller) {
  if (this->Controller != controller) {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkFoamEnsembleStatistics::GetController() {
  return this->Controller;
}

int vtkFoamEnsembleStatistics::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // what it is, is told once
  return 1;
}

int vtkFoamEnsembleStatistics::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                           vtkInformationVector* outputs) {
  auto* output = vtkTable::GetData(outputs);
  output->Initialize(); // the pipeline has given it the input's field data
  foam::filters::EnsembleSample sample;
  int failed = 0;
  try {
    vtkDataObject* const input = vtkDataObject::GetData(inputs[0]);
    auto* members = vtkPartitionedDataSet::SafeDownCast(input);
    if (!members) {
      foam::filters::fail("the input is a ", input->GetClassName(),
                          "; what is wanted is a partitioned data set with the films or the table "
                          "of a run in each partition, as Group Datasets makes it with Output Type "
                          "vtkPartitionedDataSet");
    }
    for (unsigned int i = 0; i < members->GetNumberOfPartitions(); ++i) {
      sample.add_member(members->GetPartitionAsDataObject(i), this->IncludeBoundary);
    }
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
    failed = 1;
  }

  // Every process takes part, whatever has happened in it: others wait for it.
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1) {
    int failed_anywhere = 0;
    this->Controller->AllReduce(&failed, &failed_anywhere, 1, vtkCommunicator::MAX_OP);
    std::vector<vtkSmartPointer<vtkDataObject>> samples;
    this->Controller->Gather(sample.packed(), samples, 0);
    if (failed_anywhere || this->Controller->GetLocalProcessId() != 0) {
      return 1;
    }
    sample = {};
    for (const auto& packed : samples) {
      sample.add_packed(vtkTable::SafeDownCast(packed));
    }
  }
  if (!failed) {
    sample.write_estimates(output);
  }
  return 1;
}

void vtkFoamEnsembleStatistics::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IncludeBoundary: " << this->IncludeBoundary << "\n"
     << indent << "Controller: " << this->Controller.Get() << "\n";
}
