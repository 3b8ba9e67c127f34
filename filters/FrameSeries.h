// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::filters {

/// A time series on disk: NAME.pvd, which lists times and files, and the files, NAME/NAME_0000.vtp
/// and so on. At any moment all that is listed is there and whole.
///
/// A series that is there already may be what is read while another takes its name. It gives way
/// when what replaces it is whole: all of the new one or, where it is continued, frames up to the
/// last that was given up. Until then .unfinished-NAME.pvd lists the new series. No file is
/// overwritten, and what was given up is deleted at the end.
class FrameSeries {
public:
  /// Begins to write a series, anew or, if `append`, after those frames of the one that is there
  /// which are earlier than `first_time` (s). The others are given up.
  /// \throws FoamError for a .pvd that is a folder, or cannot be read but is to be continued;
  /// std::system_error. Where the .pvd is a link, what it leads to is the series.
  FrameSeries(const std::filesystem::path& index, double first_time, bool append);

  /// Adds a frame: the content of its .vtp, and its time (s).
  /// \throws std::system_error; the series is then as it was.
  void add(double time, std::string_view vtp);
  /// Replaces what was added last by the content of another .vtp.
  void replace_last(std::string_view vtp);

  /// Ends the series. \param whole whether it has all of its frames; if not, what it was to replace
  /// and has not yet stays. \returns whether it is in its place. \throws std::system_error
  bool finish(bool whole);

  /// Whether it is to replace another, and has not yet.
  bool waits() const { return !in_place_; }

  /// What lists the series until it is in its place.
  std::filesystem::path unfinished_index() const;

private:
  struct Frame {
    double time;
    std::string file; ///< relative to the .pvd's folder
    std::vector<std::pair<std::string, std::string>> attributes{}; ///< others: part, group, name
  };

  static std::filesystem::path followed(const std::filesystem::path& index);
  static std::vector<Frame> read(const std::filesystem::path& index);
  static std::string listing(const std::vector<Frame>& frames);
  void take_place(std::vector<Frame> frames);
  std::string next_file() const;
  bool is_listed(const std::string& file) const;
  void delete_given_up();
  void give_proper_names();

  std::filesystem::path index_;
  std::filesystem::path folder_; ///< the .pvd's
  std::vector<Frame> frames_;
  std::vector<std::string> given_up_; ///< files
  double replaced_at_;                ///< time of the frame with which it takes its place, s
  bool in_place_;                     ///< the .pvd lists its frames
};

} // namespace foam::filters
