// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace foam::filters {

/// A time series on disk: NAME.pvd, which lists times and files, and the files, NAME/NAME_0000.vtp
/// and so on. At any moment all that is listed is there and whole.
class FrameSeries {
public:
  /// Begins to write a series, anew or, if `append`, after those frames of the one that is there
  /// which are earlier than `first_time` (s). The others are given up.
  /// \throws FoamError for a .pvd that cannot be read but is to be continued; std::system_error.
  FrameSeries(std::filesystem::path index, double first_time, bool append);

  /// Adds a frame: the content of its .vtp, and its time (s).
  /// \throws std::system_error; the series is then as it was.
  void add(double time, std::string_view vtp);
  /// Replaces what was added last by the content of another .vtp.
  void replace_last(std::string_view vtp);

private:
  struct Frame {
    double time;
    std::string file; ///< relative to the .pvd's folder
  };

  static std::vector<Frame> read(const std::filesystem::path& index);
  void write(const std::vector<Frame>& frames) const;

  std::filesystem::path index_;
  std::vector<Frame> frames_;
};

} // namespace foam::filters
