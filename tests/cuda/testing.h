// SPDX-License-Identifier: GPL-3.0-or-later
//
// As much of a testing framework as the device's tests need.
#pragma once

#include <cmath>
#include <iostream>
#include <string>

namespace foam::test {

inline int failures = 0;
inline bool skipped = false; ///< some test

template <class Value>
void expect(bool holds, const std::string& what, const Value& value, int line) {
  if (!holds) {
    ++failures;
    std::cerr << "line " << line << ": " << what << ", but it is " << value << "\n";
  }
}

} // namespace foam::test

#define EXPECT_TRUE(condition) foam::test::expect((condition), #condition, false, __LINE__)
#define EXPECT_EQ(a, b) foam::test::expect((a) == (b), #a " shall be " #b, (a), __LINE__)
#define EXPECT_GT(a, b) foam::test::expect((a) > (b), #a " shall be above " #b, (a), __LINE__)
#define EXPECT_NEAR(a, b, tolerance)                                                               \
  foam::test::expect(std::abs((a) - (b)) <= (tolerance), #a " shall be " #b, (a) - (b), __LINE__)
