# SPDX-License-Identifier: GPL-3.0-or-later
# The thesis's physics needs nothing but a compiler. Building foams from points needs CGAL, Newton's
# method a sparse solver; the filters need both, other builds take what is there.
set(required "")
if(FOAM_PLUGIN)
  set(required REQUIRED)
endif()
find_package(Eigen3 3.4 ${required} NO_MODULE QUIET)
find_package(CGAL ${required} QUIET)
find_package(MUMPS QUIET)
find_package(Threads REQUIRED)
