// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <vtkSmartPointer.h>

class vtkDataObject;
class vtkTable;

namespace foam::filters {

/// The values that the members of an ensemble have for each quantity.
class EnsembleSample {
public:
  /// Adds a member: a foam's films, which are measured, or a table. What is empty is no member.
  /// \param include_boundary whether bubbles that touch the world count in the averages over films.
  /// \throws FoamError naming what is wrong with the member.
  void add_member(vtkDataObject* member, bool include_boundary);

  /// The values as a table that other processes can be sent.
  vtkSmartPointer<vtkTable> packed() const;

  /// Adds the values of a packed sample.
  void add_packed(vtkTable* packed);

  /// Writes a row for each quantity: those of the whole foam first, each group in the order in
  /// which their names were met.
  void write_estimates(vtkTable* table) const;

private:
  /// Whether it is for one number of sides, the name's place in names_, and the sides or 0.
  using Quantity = std::tuple<bool, std::size_t, int>;

  void add(const std::string& name, int sides, double value);
  void add_table(vtkTable* table);

  std::vector<std::string> names_; ///< in the order in which they were met
  std::map<Quantity, std::vector<double>> values_;
  int members_by_sides_ = 0; ///< how many have told their numbers of sides
};

} // namespace foam::filters
