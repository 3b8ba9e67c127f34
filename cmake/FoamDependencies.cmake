# SPDX-License-Identifier: GPL-3.0-or-later
# The physics needs nothing but a compiler. Building foams from points needs CGAL; the filters need it,
# other builds take what is there.
set(required "")
if(FOAM_PLUGIN)
  set(required REQUIRED)
endif()
find_package(CGAL ${required} QUIET)
find_package(Threads REQUIRED)
