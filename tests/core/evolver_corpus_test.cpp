// SPDX-License-Identifier: GPL-3.0-or-later
// Files of one construct each, and what fuzzers made of them: see tests/fuzz.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "../fuzz/one_input.h"

namespace foam::test {
namespace {

/// Calls visit(content, name) for each file of a folder of data. \returns how many there were
template <class Visit> int for_each_file(const std::string& folder, const Visit& visit) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(FOAM_TEST_DATA) / folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    visit(std::string{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()},
          entry.path().filename().string());
    ++files;
  }
  return files;
}

TEST(Corpus, DatafilesAreFoamsOrErrors) {
  std::vector<std::string> refused;
  const int files =
      for_each_file("datafiles", [&](const std::string& text, const std::string& name) {
        if (!read_datafile(text)) {
          refused.push_back(name);
        }
      });
  EXPECT_GE(files, 30);
  std::ranges::sort(refused);
  EXPECT_EQ(refused, (std::vector<std::string>{"includes_itself.fe", "lagrange.fe", "no_surface.fe",
                                               "one_sided.fe", "parabola.fe", "soapfilm.fe"}));
}

/// Pictures that are pieces of those files: most are noise, and none is more than that.
TEST(Corpus, BytesAsLabelsAreFoamsOrErrors) {
  int foams = 0;
  for_each_file("datafiles", [&](const std::string& text, const std::string&) {
    for (const std::size_t size : {40, 120, 360}) {
      for (std::uint8_t kind = 0; kind < 8; ++kind) {
        std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(size / 20 + kind), kind};
        for (std::size_t i = 0; i < std::min(size, text.size()); ++i) {
          bytes.push_back(static_cast<std::uint8_t>(text[i]) % 5);
        }
        foams += read_labels(bytes) ? 1 : 0;
      }
    }
  });
  EXPECT_GT(foams, 50);
}

} // namespace
} // namespace foam::test
