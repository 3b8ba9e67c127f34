// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace foam::filters {

/// The name that a file has until it is whole.
std::filesystem::path unfinished(const std::filesystem::path& path);

/// Writes a file under the name that it has until it is whole, and sees that it lies on the disk.
/// \throws std::system_error naming the file and the cause; nothing is left of it then.
void write_unfinished(const std::filesystem::path& path, std::string_view content);

/// Writes a file that is there whole or not at all, whatever happens: under another name first,
/// which becomes its own once all of it lies on the disk.
/// \throws std::system_error naming the file and the cause; what was there before is as it was.
void write_whole(const std::filesystem::path& path, std::string_view content);

} // namespace foam::filters
