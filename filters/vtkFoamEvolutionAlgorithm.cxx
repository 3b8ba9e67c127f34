// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamEvolutionAlgorithm.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationDataObjectMetaDataKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "FilmReading.h"
#include "FoamTimeline.h"
#include "FoamWriting.h"
#include "Message.h"
#include "PipelineRequest.h"
#include "coarsening/end.h"
#include "mesh/filling.h"
#include "physics/equilibrium_measures.h"
#include "physics/measured_targets.h"

vtkInformationKeyMacro(vtkFoamEvolutionAlgorithm, RUN, DataObjectMetaData);

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace {

using foam::filters::message;

/// A frame is shown at times that are earlier than its own by less than this, in time steps: what
/// rounding may take from a time on its way through a user interface.
constexpr double TIME_TOLERANCE = 1e-6;

/// What to do about target areas of films that were changed.
constexpr const char* TAKE_MEASURED = "TargetAreas Measured takes the areas that are there";

/// The time step (s) of the run that an input is; 0 if it is none.
double TimeStepOfRun(vtkInformation* input) {
  vtkDataObject* run = input->Get(vtkFoamEvolutionAlgorithm::RUN());
  vtkDataArray* step = run ? run->GetFieldData()->GetArray("TimeStep") : nullptr;
  return step && input->Length(SDDP::TIME_STEPS()) > 0 ? step->GetComponent(0, 0) : 0;
}

vtkSmartPointer<vtkDataObject> RunOf(double timeStep) {
  vtkNew<vtkDoubleArray> step;
  step->SetName("TimeStep");
  step->InsertNextValue(timeStep);
  auto run = vtkSmartPointer<vtkDataObject>::New();
  run->GetFieldData()->AddArray(step);
  return run;
}

/// Whether a time step leads to a later time, of this precision.
bool TimeCanPass(double start, double timeStep) {
  return std::isfinite(timeStep) && start + timeStep > start;
}

/// The last frame that is not later than the requested time; frame 0 if none was requested.
int RequestedFrame(const std::vector<double>& times, double timeStep, vtkInformation* output) {
  if (!output->Has(SDDP::UPDATE_TIME_STEP())) {
    return 0;
  }
  const double time = output->Get(SDDP::UPDATE_TIME_STEP()) + TIME_TOLERANCE * timeStep;
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return std::max(0, static_cast<int>(after - times.begin()) - 1);
}

} // namespace

/// A run and what has been told about it.
struct vtkFoamEvolutionAlgorithm::Simulation {
  Simulation(foam::FilmSet start, const foam::filters::FoamTimeline::Settings& settings)
      : Timeline(std::move(start), settings) {}

  foam::filters::FoamTimeline Timeline;
  vtkMTimeType InputTime = 0; ///< the input is as it was when it was read
  int TargetAreas = FromFilms;
  int CheckedFrame = -1;
  bool EndTold = false;
};

struct vtkFoamEvolutionAlgorithm::Settings : foam::filters::FoamTimeline::Settings {};

/// What a run is to begin with.
struct vtkFoamEvolutionAlgorithm::Start {
  foam::FilmSet Films;
  double MeanArea = 0; ///< of the bubbles' targets, cm²
  std::string Doubt;   ///< what is wrong with what the films say of themselves
  vtkTimeStamp Read;
};

vtkFoamEvolutionAlgorithm::vtkFoamEvolutionAlgorithm(int numberOfFrames)
    : NumberOfFrames(numberOfFrames) {
  this->SetNumberOfOutputPorts(3);
}

vtkFoamEvolutionAlgorithm::~vtkFoamEvolutionAlgorithm() = default;

int vtkFoamEvolutionAlgorithm::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // what it is, is told once
  return 1;
}

int vtkFoamEvolutionAlgorithm::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                                  vtkInformationVector* outputs) {
  vtkInformation* const from = inputs[0]->GetInformationObject(0);
  this->RequestStart(from);
  if (const double stepOfRun = TimeStepOfRun(from); stepOfRun > 0) {
    // What is not known before the input has been computed to its end is corrected then.
    const double start = from->Get(SDDP::UPDATE_TIME_STEP());
    const double asked = this->GetAskedTimeStep();
    if (this->Run && this->Run->TargetAreas == this->TargetAreas &&
        this->Run->Timeline.is_of(this->GetSettings()) &&
        this->Run->Timeline.start_time() == start) {
      this->AnnounceRun(outputs);
    } else {
      this->Announce(start, asked > 0 ? asked : stepOfRun, {}, outputs);
    }
    return 1;
  }
  // The frames begin at the time that the input's data carry, which no information tells before
  // they are there: a .vtp that is read back alone, to resume a run, has it in its field data. So
  // the input is brought up to date here; that is work which the request for data would do anyway.
  int upstreamPort = 0;
  this->GetInputAlgorithm(0, 0, upstreamPort)->Update(upstreamPort);
  vtkPolyData* const input = vtkPolyData::GetData(inputs[0]);
  if (!input) {
    return 1; // the request for data tells
  }
  if (this->RunIsOf(this->GetSettings(), input)) {
    this->AnnounceRun(outputs);
  } else {
    this->Announce(foam::filters::read_time(input), this->ReadTimeStep(input), {}, outputs);
  }
  return 1;
}

/// Announces the times of the frames from a start (s), up to the last of a run that ended.
void vtkFoamEvolutionAlgorithm::Announce(double start, double timeStep,
                                         const std::optional<int>& end,
                                         vtkInformationVector* outputs) {
  const bool valid = this->NumberOfFrames > 0 && TimeCanPass(start, timeStep);
  const int count = valid ? std::min(this->NumberOfFrames, end.value_or(this->NumberOfFrames)) : 0;
  const auto times = foam::filters::frame_times(start, timeStep, count);
  const double range[2] = {times.front(), times.back()};
  const auto run = RunOf(timeStep);
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port) {
    vtkInformation* output = outputs->GetInformationObject(port);
    output->Set(SDDP::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    output->Set(SDDP::TIME_RANGE(), range, 2);
    output->Set(RUN(), run);
  }
  this->StartTime = start;
}

/// Announces those of the present run.
void vtkFoamEvolutionAlgorithm::AnnounceRun(vtkInformationVector* outputs) {
  const auto& timeline = this->Run->Timeline;
  this->Announce(timeline.start_time(), timeline.time_step(), timeline.end(), outputs);
}

int vtkFoamEvolutionAlgorithm::RequestUpdateExtent(vtkInformation* request,
                                                   vtkInformationVector** inputs,
                                                   vtkInformationVector* outputs) {
  if (foam::filters::is_first_piece(request, outputs)) {
    foam::filters::request_whole(inputs[0]->GetInformationObject(0));
  }
  this->RequestStart(inputs[0]->GetInformationObject(0));
  return 1;
}

/// Asks the input for the time step to begin with: the frames' times are made here, not upstream.
void vtkFoamEvolutionAlgorithm::RequestStart(vtkInformation* input) const {
  const int count = input->Length(SDDP::TIME_STEPS());
  if (count > 0) {
    const int start = this->StartFrom == First ? 0 : count - 1;
    input->Set(SDDP::UPDATE_TIME_STEP(), input->Get(SDDP::TIME_STEPS())[start]);
  } else {
    input->Remove(SDDP::UPDATE_TIME_STEP());
  }
}

void vtkFoamEvolutionAlgorithm::MakeFoam(vtkInformation* request, vtkInformationVector** inputs,
                                         vtkInformationVector* outputs) {
  this->PrepareSimulation(inputs);
  auto& timeline = this->Run->Timeline;
  this->AdvanceTo(RequestedFrame(
      foam::filters::frame_times(timeline.start_time(), timeline.time_step(), this->NumberOfFrames),
      timeline.time_step(), foam::filters::requested_output(request, outputs)));
  this->AnnounceRun(outputs);
  this->WriteOutputs(timeline.sample(this->GetChordError()), outputs);
  foam::filters::write_events(timeline.events(), vtkPolyData::GetData(outputs, 2));
  for (int i = 0; i < this->GetNumberOfOutputPorts(); ++i) {
    vtkPolyData::GetData(outputs, i)
        ->GetInformation()
        ->Set(vtkDataObject::DATA_TIME_STEP(), timeline.record().time);
  }
}

bool vtkFoamEvolutionAlgorithm::RunIsOf(const Settings& settings, vtkPolyData* input) const {
  return this->Run && this->Run->InputTime == input->GetMTime() &&
         this->Run->TargetAreas == this->TargetAreas && this->Run->Timeline.is_of(settings);
}

vtkFoamEvolutionAlgorithm::Settings vtkFoamEvolutionAlgorithm::GetSettings() const {
  return {{this->GetEvolutionOptions(), this->KeyframeInterval}};
}

/// That of a run of the input, s; 0 if it does not follow from it.
double vtkFoamEvolutionAlgorithm::ReadTimeStep(vtkPolyData* input) {
  if (const double asked = this->GetAskedTimeStep(); asked > 0) {
    return asked;
  }
  try {
    const Start& start = this->ReadStart(input);
    return this->GetAutomaticTimeStep(start.Films, start.MeanArea);
  } catch (const std::exception&) {
    return 0; // the request for data tells
  }
}

void vtkFoamEvolutionAlgorithm::PrepareSimulation(vtkInformationVector** inputs) {
  const Settings settings = this->GetSettings();
  if (this->NumberOfFrames < 0) {
    foam::filters::fail("NumberOfFrames must be at least 0, but is ", this->NumberOfFrames);
  }
  if (this->KeyframeMemory < 0) {
    foam::filters::fail("KeyframeMemory must be at least 0 MiB, but is ", this->KeyframeMemory);
  }

  vtkPolyData* const input = foam::filters::films_in(vtkDataObject::GetData(inputs[0]));
  if (!this->RunIsOf(settings, input)) {
    this->ReadStart(input);
    const std::unique_ptr<Start> begin = std::move(this->Next);
    if (!this->Run || !this->Run->Timeline.is_of(begin->Films, settings)) {
      this->Run.reset();
      auto run = std::make_unique<Simulation>(std::move(begin->Films), settings);
      const double start = run->Timeline.start_time();
      const double timeStep = run->Timeline.time_step();
      if (!TimeCanPass(start, timeStep)) {
        foam::filters::fail("TimeStep ", timeStep, " s leads to no later time than ", start, " s");
      }
      this->Run = std::move(run);
      this->WarnOfStart(foam::foam_of(this->Run->Timeline.start()));
      if (begin->Doubt.empty()) {
        this->WarnIfNotConverged();
      } else {
        this->Run->CheckedFrame = 0;
        vtkWarningMacro(<< begin->Doubt);
      }
      if (const std::string end = foam::filters::read_end(input); !end.empty()) {
        vtkWarningMacro("The input is the last foam of a run that ended: "
                        << end << ". It is tried again from there.");
      }
    }
    this->Run->InputTime = input->GetMTime();
    this->Run->TargetAreas = this->TargetAreas;
  }
  this->Run->Timeline.limit_memory(static_cast<std::size_t>(this->KeyframeMemory) << 20);
}

/// What a run of the input begins with, read and measured.
/// \throws FoamError if it is no foam, or its target areas do not fill its space.
const vtkFoamEvolutionAlgorithm::Start& vtkFoamEvolutionAlgorithm::ReadStart(vtkPolyData* input) {
  if (this->Next && this->Next->Read > input->GetMTime() && this->Next->Read > this->GetMTime()) {
    return *this->Next;
  }
  this->Next.reset();
  auto start = std::make_unique<Start>();
  start->Films = foam::filters::read_films(input);
  foam::Foam foam = foam::filters::checked_foam(start->Films);
  const double rounding = foam::filters::coordinate_rounding(input);
  foam::EquilibriumReport said = foam.report;
  std::string scaled;
  if (this->TargetAreas == Measured) {
    foam::take_measured_targets(foam);
    said = this->OfMeasuredTargets(said, foam);
    foam.time_step = 0; // those that went with other areas
    foam.thresholds = {};
  } else if (!foam::holds(said, foam, rounding)) {
    const double sum = foam.bubble_count() * foam.mean_area();
    scaled = foam::filters::told_scaling(
        sum, foam::fill_space(foam, foam::kMeasuredAreas, TAKE_MEASURED));
  }
  foam.report = foam::confirmed(said, foam, rounding);
  start->Doubt = foam::filters::doubt(said, foam.report);
  if (!start->Doubt.empty() && this->TargetAreas == FromFilms) {
    start->Doubt += message(" ", TAKE_MEASURED, ".");
  }
  start->Doubt += message(start->Doubt.empty() ? "" : " ", scaled);
  start->Films = foam::film_set(foam);
  start->MeanArea = foam.mean_area();
  start->Read.Modified();
  this->Next = std::move(start);
  return *this->Next;
}

/// What films can be held to have said of themselves whose areas are their targets now, and whose
/// pressures were fitted.
foam::EquilibriumReport vtkFoamEvolutionAlgorithm::OfMeasuredTargets(foam::EquilibriumReport said,
                                                                     const foam::Foam& foam) {
  said.max_area_error = 0;
  const double residual = foam::measured_report(foam).residual;
  if (residual <= this->GetTolerance()) {
    said.residual = std::max(said.residual, residual);
  }
  return said;
}

void vtkFoamEvolutionAlgorithm::AdvanceTo(int frame) {
  auto& timeline = this->Run->Timeline;
  double progress = 0;
  try {
    timeline.go_to(
        frame, [&] { return this->PollAbort(progress); },
        [&](int done, int todo) {
          progress = static_cast<double>(done) / todo;
          this->WarnIfNotConverged();
        });
  } catch (const foam::Aborted&) {
    // The last frame that was complete is shown; the next request goes on from there.
  } catch (const std::exception& error) {
    vtkErrorMacro("Frame " << frame << " could not be computed: " << error.what() << ". Frame "
                           << timeline.frame() << ", the last that is whole, is shown.");
  }
  if (timeline.end() && !this->Run->EndTold) {
    this->Run->EndTold = true;
    const foam::FoamRecord record = timeline.record();
    vtkWarningMacro("The foam ended at time " << record.time << " s, frame " << *timeline.end()
                                              << ": " << foam::reason(*record.ended)
                                              << ". Later times show the last foam.");
  }
}

double vtkFoamEvolutionAlgorithm::GetAutomaticTimeStep(const foam::FilmSet&, double) const {
  return 0;
}

void vtkFoamEvolutionAlgorithm::WarnOfStart(const foam::Foam&) {}

void vtkFoamEvolutionAlgorithm::WarnIfNotConverged() {
  const auto& timeline = this->Run->Timeline;
  if (timeline.frame() <= this->Run->CheckedFrame) {
    return;
  }
  this->Run->CheckedFrame = timeline.frame();
  const foam::FoamRecord record = timeline.record();
  if (!record.report.converged) {
    vtkWarningMacro("Frame " << timeline.frame() << ", time " << record.time
                             << " s, is not in equilibrium: angles are off by up to "
                             << record.report.max_angle_error << " rad, areas by up to "
                             << record.report.max_area_error << " times their targets, residual "
                             << record.report.residual << ".");
  }
}

void vtkFoamEvolutionAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StartFrom: " << this->StartFrom << "\n"
     << indent << "StartTime: " << this->StartTime << "\n"
     << indent << "TargetAreas: " << this->TargetAreas << "\n"
     << indent << "NumberOfFrames: " << this->NumberOfFrames << "\n"
     << indent << "KeyframeInterval: " << this->KeyframeInterval << "\n"
     << indent << "KeyframeMemory: " << this->KeyframeMemory << "\n";
}
