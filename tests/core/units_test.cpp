// SPDX-License-Identifier: GPL-3.0-or-later
//
// A foam is homogeneous: in other units it is the same foam.
#include "mesh/units.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scaled_foams.h"

namespace foam::test {
namespace {

TEST(Units, ChangeNothingButNumbers) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
      const Foam start = scaled_foam(boundary, 64, 5, {});
      const auto reference = coarsened(start, coarsening_options(stepping, {}));
      EXPECT_LT(reference->foam().bubble_count(), 64) << "something happens";
      for (const Scale& scale :
           {Scale{1e-9, 1, {}}, Scale{1e9, 1, {}}, Scale{1e-3, 1, {}}, Scale{500, 1, {}},
            Scale{1, 4e-12, {}}, Scale{1, 4e12, {}}, Scale{1e-6, 1e6, {}}, Scale{3e6, 1e-6, {}}}) {
        const Foam scaled = scaled_foam(boundary, 64, 5, scale);
        expect_same_foam(scaled, scale, start, 1e-12);
        const auto coarsening = coarsened(scaled, coarsening_options(stepping, scale));
        expect_valid(coarsening->foam(), name(scale));
        expect_same_foam(coarsening->foam(), scale, reference->foam(), 1e-12);
      }
    }
  }
}

TEST(Units, CostNoBitWhereTheyArePowersOfTwo) {
  const Scale scale{0x1p-20, 0x1p13, {}};
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    const auto reference =
        coarsened(scaled_foam(boundary, 49, 7, {}), coarsening_options(Stepping::Events, {}));
    const auto coarsening =
        coarsened(scaled_foam(boundary, 49, 7, scale), coarsening_options(Stepping::Events, scale));
    Foam foam = coarsening->foam();
    change_units(foam, {1 / scale.length, 1 / scale.tension, {}});
    EXPECT_EQ(foam.position, reference->foam().position);
    EXPECT_EQ(foam.film_angle, reference->foam().film_angle);
    EXPECT_EQ(foam.pressure, reference->foam().pressure);
    EXPECT_EQ(foam.target_area, reference->foam().target_area);
    EXPECT_EQ(foam.energy(), reference->foam().energy());
  }
}

/// Coordinates of maps, say. Places are rounded to 5e-10 of a spacing there.
TEST(Units, AreThoseOfAPlaceFarAway) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    for (const double length : {1.0, 1e-4}) {
      const Scale scale{length, 1, {4e6, -3e6}};
      const Foam start = scaled_foam(boundary, 64, 5, {});
      const auto reference = coarsened(start, coarsening_options(Stepping::Events, {}));
      const auto coarsening = coarsened(scaled_foam(boundary, 64, 5, scale),
                                        coarsening_options(Stepping::Events, scale));
      expect_same_foam(coarsening->foam(), scale, reference->foam(), 1e-9);
    }
  }
}

TEST(Units, LeaveAFoamItsBitsThereAndBack) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    for (const Scale& scale : {Scale{1e-6, 3, {}}, Scale{7, 1e-9, {4e6, -3e6}},
                               Scale{0.3, 1, {100, 5}}, Scale{1e9, 1, {-17, 0.5}}}) {
      for (const UnitSteps steps : {UnitSteps::Fine, UnitSteps::Coarse}) {
        const Foam foam = scaled_foam(boundary, 30, 3, scale);
        const UnitChange own = own_units(foam, steps);
        Foam changed = foam;
        change_units(changed, own);
        const double largest = steps == UnitSteps::Fine ? std::sqrt(2) : 8;
        EXPECT_LE(changed.mean_spacing(), largest * (1 + 1e-12)) << name(scale);
        EXPECT_GE(changed.mean_spacing(), (1 - 1e-12) / largest) << name(scale);
        for (const Vec2 place : changed.position) {
          EXPECT_LT(norm(place), 200 * largest) << name(scale);
        }
        change_units(changed, own.inverse());
        EXPECT_EQ(film_set(changed), film_set(foam)) << name(scale);
      }
    }
  }
}

/// The thesis's constants are absolute numbers for foams like its own.
TEST(Units, AreTheThesisOwnNearItsFoams) {
  for (const double size : {0.2, 1.0, 7.0}) {
    const Foam foam = scaled_foam(Boundary::Free, 20, 1, {size, size, {}});
    EXPECT_TRUE(own_units(foam, UnitSteps::Coarse).changes_nothing());
  }
}

} // namespace
} // namespace foam::test
