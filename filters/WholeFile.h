// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace foam::filters {

/// Writes a file that is there whole or not at all, whatever happens: under another name first,
/// which becomes its own once all of it lies on the disk.
/// \throws std::system_error naming the file and the cause; what was there before is as it was.
void write_whole(const std::filesystem::path& path, std::string_view content);

} // namespace foam::filters
