// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "mesh/film_set.h"

namespace foam::test {

/// The rows of a CSV file of tests/data as maps from column name to text.
inline std::vector<std::map<std::string, std::string>> read_csv(const std::string& name) {
  std::ifstream file(std::filesystem::path(FOAM_TEST_DATA) / name);
  if (!file) {
    throw std::runtime_error("cannot read " + name);
  }
  const auto split = [](const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
      cells.push_back(cell);
    }
    return cells;
  };
  std::string line;
  const auto next_line = [&] {
    const bool found = static_cast<bool>(std::getline(file, line));
    std::erase(line, '\r');
    return found && !line.empty();
  };
  next_line();
  const auto header = split(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (next_line()) {
    const auto cells = split(line);
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < header.size() && i < cells.size(); ++i) {
      row[header[i]] = cells[i];
    }
    rows.push_back(row);
  }
  return rows;
}

inline double number(const std::map<std::string, std::string>& row, const std::string& column) {
  return std::stod(row.at(column));
}

/// The periodic foam of 100 bubbles that Surface Evolver brought to equilibrium; line tension 1.
inline FilmSet evolver_foam() {
  FilmSet set;
  set.surroundings = {Boundary::Periodic, Lattice::rectangle(0, 10, 0, 10)};
  set.surface_tension = 0.5;
  for (const auto& row : read_csv("evolver-100/foam100_eq_vertices.csv")) {
    set.junctions.push_back({number(row, "x"), number(row, "y")});
  }
  for (const auto& row : read_csv("evolver-100/foam100_eq_edges.csv")) {
    const auto whole = [&](const char* column) { return std::stoi(row.at(column)); };
    set.films.push_back({whole("v0"),
                         whole("v1"),
                         whole("cell_left"),
                         whole("cell_right"),
                         0.5 * number(row, "turn_angle"),
                         {whole("wrap_x"), whole("wrap_y")}});
  }
  for (const auto& row : read_csv("evolver-100/foam100_eq_cells.csv")) {
    set.bubbles.push_back({std::stoi(row.at("cell")), number(row, "pressure_minus_mean"),
                           number(row, "area_target")});
  }
  return set;
}

} // namespace foam::test
