// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of Surface Evolver's datafiles in tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "evolver/read_foam.h"

namespace foam::test {

inline std::string no_file(const std::string& name) {
  throw FoamError("cannot read " + name);
}

inline EvolverFoam read(const std::string& text) {
  return read_evolver(text, no_file);
}

inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

inline std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const FoamError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace foam::test
