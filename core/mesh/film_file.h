// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "mesh/film_set.h"

namespace foam {

/// Writes a foam's state as text, without VTK: lines of a name and values, numbers such that they
/// read back as the same bits. \throws FoamError if the file cannot be written.
void write_film_file(const std::filesystem::path& path, const FilmSet& set);

/// \throws FoamError if the file cannot be read or is not such a file; the message names the file
/// and what was expected.
FilmSet read_film_file(const std::filesystem::path& path);

} // namespace foam
