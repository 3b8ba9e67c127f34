// SPDX-License-Identifier: GPL-3.0-or-later
#include "FrameSeries.h"

#include <charconv>
#include <iomanip>
#include <sstream>
#include <utility>

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include "Message.h"
#include "WholeFile.h"
#include "base/error.h"

namespace foam::filters {
namespace {

/// The shortest decimal that is read back as the same number.
std::string decimal(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

} // namespace

FrameSeries::FrameSeries(std::filesystem::path index, double first_time, bool append)
    : index_(std::move(index)) {
  const auto folder = index_.parent_path();
  std::filesystem::create_directories(folder / index_.stem());
  std::vector<std::string> given_up;
  if (std::filesystem::exists(index_)) {
    try {
      for (auto& frame : read(index_)) {
        if (append && frame.time < first_time) {
          frames_.push_back(std::move(frame));
        } else {
          given_up.push_back(std::move(frame.file));
        }
      }
    } catch (const FoamError&) {
      if (append) {
        throw;
      }
    }
  }
  write(frames_);
  for (const std::filesystem::path file : given_up) {
    if (file.parent_path() == index_.stem()) {
      std::filesystem::remove(folder / file);
    }
  }
}

void FrameSeries::add(double time, std::string_view vtp) {
  std::ostringstream name;
  name << index_.stem().string() << '_' << std::setw(4) << std::setfill('0') << frames_.size()
       << ".vtp";
  const auto file = index_.stem() / name.str();
  write_whole(index_.parent_path() / file, vtp);
  auto frames = frames_;
  frames.push_back({time, file.string()});
  write(frames);
  frames_ = std::move(frames);
}

void FrameSeries::replace_last(std::string_view vtp) {
  write_whole(index_.parent_path() / frames_.back().file, vtp);
}

std::vector<FrameSeries::Frame> FrameSeries::read(const std::filesystem::path& index) {
  const auto root =
      vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(index.c_str()));
  vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!collection) {
    fail(index.string(), " is not a time series that could be continued");
  }
  std::vector<Frame> frames;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* element = collection->GetNestedElement(i);
    double time = 0;
    const char* file = element->GetAttribute("file");
    if (!file || !element->GetScalarAttribute("timestep", time)) {
      fail(index.string(), " lists a frame, number ", i, ", without time or file");
    }
    frames.push_back({time, file});
  }
  return frames;
}

void FrameSeries::write(const std::vector<Frame>& frames) const {
  vtkNew<vtkXMLDataElement> root;
  root->SetName("VTKFile");
  root->SetAttribute("type", "Collection");
  root->SetAttribute("version", "0.1");
  vtkNew<vtkXMLDataElement> collection;
  collection->SetName("Collection");
  root->AddNestedElement(collection);
  for (const auto& frame : frames) {
    vtkNew<vtkXMLDataElement> element;
    element->SetName("DataSet");
    element->SetAttribute("timestep", decimal(frame.time).c_str());
    element->SetAttribute("file", frame.file.c_str());
    collection->AddNestedElement(element);
  }
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n";
  root->PrintXML(text, vtkIndent());
  write_whole(index_, text.str());
}

} // namespace foam::filters
