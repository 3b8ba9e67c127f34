// SPDX-License-Identifier: GPL-3.0-or-later
#include "FrameSeries.h"

#include <algorithm>
#include <charconv>
#include <iomanip>
#include <limits>
#include <sstream>
#include <system_error>
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

/// Before the name of a frame's file while one that is to be given up has the name.
constexpr std::string_view kWaiting = ".unfinished-new-";

/// The shortest decimal that is read back as the same number.
std::string decimal(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// The number after the last underscore of a file's name; −1 if there is none.
int number_in(const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem();
  int number = -1;
  std::from_chars(stem.data() + stem.rfind('_') + 1, stem.data() + stem.size(), number);
  return number;
}

/// Gives a file a second name.
void link(const std::filesystem::path& file, const std::filesystem::path& name) {
  std::error_code no_links;
  std::filesystem::create_hard_link(file, name, no_links);
  if (no_links) {
    std::filesystem::copy_file(file, name);
  }
}

} // namespace

FrameSeries::FrameSeries(const std::filesystem::path& index, double first_time, bool append)
    : index_(followed(index)), folder_(index_.parent_path()),
      replaced_at_(append ? first_time : std::numeric_limits<double>::infinity()),
      in_place_(!std::filesystem::exists(index_)) {
  std::filesystem::create_directories(folder_ / index_.stem());
  if (in_place_) {
    return;
  }
  try {
    for (auto& frame : read(index_)) {
      if (append && frame.time < first_time) {
        frames_.push_back(std::move(frame));
      } else {
        replaced_at_ = std::max(replaced_at_, frame.time);
        given_up_.push_back(std::move(frame.file));
      }
    }
  } catch (const FoamError&) {
    if (append) {
      throw;
    }
  }
}

std::filesystem::path FrameSeries::followed(const std::filesystem::path& index) {
  if (std::filesystem::is_directory(index)) {
    fail("cannot write ", index.string(), ": it is a folder");
  }
  return std::filesystem::exists(index) ? std::filesystem::canonical(index) : index;
}

void FrameSeries::add(double time, std::string_view vtp) {
  const std::string file = next_file();
  write_whole(folder_ / file, vtp);
  auto frames = frames_;
  frames.push_back({time, file});
  if (in_place_ || time >= replaced_at_) {
    take_place(std::move(frames));
  } else {
    write_unfinished(index_, listing(frames));
    frames_ = std::move(frames);
  }
}

bool FrameSeries::finish(bool whole) {
  if (!in_place_ && whole) {
    take_place(frames_);
  }
  if (in_place_) {
    delete_given_up();
    give_proper_names();
  }
  return in_place_;
}

std::filesystem::path FrameSeries::unfinished_index() const {
  return unfinished(index_);
}

void FrameSeries::take_place(std::vector<Frame> frames) {
  write_whole(index_, listing(frames));
  frames_ = std::move(frames);
  in_place_ = true;
}

/// A name that no file has, after those of the frames before. Where one has it that is to be given
/// up, the name to wait for it under: a file that has that is a series' that was never finished.
std::string FrameSeries::next_file() const {
  int number = frames_.empty() ? 0 : number_in(frames_.back().file) + 1;
  for (number = std::max(number, static_cast<int>(frames_.size()));; ++number) {
    std::ostringstream name;
    name << index_.stem().string() << '_' << std::setw(4) << std::setfill('0') << number << ".vtp";
    std::string proper = index_.stem() / name.str();
    if (!std::filesystem::exists(folder_ / proper)) {
      return proper;
    }
    std::string waiting = index_.stem() / (std::string(kWaiting) + name.str());
    if (std::ranges::count(given_up_, proper) > 0 && !is_listed(waiting)) {
      return waiting;
    }
  }
}

bool FrameSeries::is_listed(const std::string& file) const {
  return std::ranges::count(given_up_, file) + std::ranges::count(frames_, file, &Frame::file) > 0;
}

void FrameSeries::delete_given_up() {
  const auto kept = [&](const std::filesystem::path& file) {
    return std::ranges::any_of(frames_, [&](const Frame& frame) {
      return (folder_ / frame.file).lexically_normal() == (folder_ / file).lexically_normal();
    });
  };
  for (const std::filesystem::path file : given_up_) {
    if (file.parent_path() == index_.stem() && !kept(file)) {
      std::filesystem::remove(folder_ / file);
    }
  }
  given_up_.clear();
}

void FrameSeries::give_proper_names() {
  auto frames = frames_;
  std::vector<std::string> old_names;
  for (Frame& frame : frames) {
    const std::filesystem::path file = frame.file;
    const std::string name = file.filename();
    if (file.parent_path() != index_.stem() || !name.starts_with(kWaiting)) {
      continue;
    }
    const auto proper = index_.stem() / name.substr(kWaiting.size());
    if (!std::filesystem::exists(folder_ / proper)) {
      link(folder_ / file, folder_ / proper);
      frame.file = proper;
      old_names.push_back(file);
    }
  }
  if (!old_names.empty()) {
    take_place(std::move(frames));
    for (const std::string& file : old_names) {
      std::filesystem::remove(folder_ / file);
    }
  }
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
    Frame& frame = frames.emplace_back(Frame{time, file});
    for (int k = 0; k < element->GetNumberOfAttributes(); ++k) {
      const std::string name = element->GetAttributeName(k);
      if (name != "timestep" && name != "file") {
        frame.attributes.emplace_back(name, element->GetAttributeValue(k));
      }
    }
  }
  return frames;
}

std::string FrameSeries::listing(const std::vector<Frame>& frames) {
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
    for (const auto& [name, value] : frame.attributes) {
      element->SetAttribute(name.c_str(), value.c_str());
    }
    element->SetAttribute("file", frame.file.c_str());
    collection->AddNestedElement(element);
  }
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n";
  root->PrintXML(text, vtkIndent());
  return text.str();
}

} // namespace foam::filters
