// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/film_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "foams.h"

namespace foam {
namespace {

std::filesystem::path file_of_this_test() {
  const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::temp_directory_path() / (std::string("foam_") + test->name() + ".txt");
}

std::string error_of(const std::string& text) {
  const auto path = file_of_this_test();
  std::ofstream(path) << text;
  try {
    read_film_file(path);
  } catch (const FoamError& error) {
    return error.what();
  }
  return {};
}

TEST(FilmFile, ReadsBackTheSameBits) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    Foam foam = test::random_foam(30, boundary);
    foam.time = 1.0 / 3;
    foam.t1_count = 7;
    const auto path = file_of_this_test();
    write_film_file(path, film_set(foam));
    const Foam back = foam_of(read_film_file(path));
    EXPECT_EQ(back.position, foam.position);
    EXPECT_EQ(back.film_angle, foam.film_angle);
    EXPECT_EQ(back.film_wrap, foam.film_wrap);
    EXPECT_EQ(back.pressure, foam.pressure);
    EXPECT_EQ(back.target_area, foam.target_area);
    EXPECT_EQ(back.half_bubble, foam.half_bubble);
    EXPECT_EQ(back.bubble_id, foam.bubble_id);
    EXPECT_EQ(back.boundary, foam.boundary);
    EXPECT_EQ(back.box, foam.box);
    EXPECT_EQ(back.surface_tension, foam.surface_tension);
    EXPECT_EQ(back.time, foam.time);
    EXPECT_EQ(back.t1_count, 7);
    std::filesystem::remove(path);
  }
}

TEST(FilmFile, SaysWhatIsWrong) {
  EXPECT_THROW(read_film_file("/nowhere/foam.txt"), FoamError);
  EXPECT_THROW(write_film_file("/nowhere/foam.txt", {}), FoamError);
  EXPECT_NE(error_of("a picture").find("expected foam-films-1, but found \"a\""),
            std::string::npos);
  EXPECT_NE(error_of("foam-films-1 boundary 7 ").find("there is no boundary 7"), std::string::npos);
  EXPECT_NE(error_of("foam-films-1 boundary 0 box 0 1 0 one").find("\"one\""), std::string::npos);
  std::filesystem::remove(file_of_this_test());
}

} // namespace
} // namespace foam
