# SPDX-License-Identifier: GPL-3.0-or-later
# foam_find_paraview(): find_package(ParaView), in spite of what distributors have left wrong in the
# files that CMake reads. Nothing outside the build folder is changed.

# Defines the Python modules that are imported by a package's file of targets, if it names files that
# do not exist: Debian's leave out the suffix that these have (vtkCommonCore.so for
# vtkCommonCore.cpython-313-x86_64-linux-gnu.so). The file itself does nothing any more when the
# package includes it, since all of its targets are there.
function(foam_mend_python_targets targets)
  cmake_path(GET targets PARENT_PATH directory)
  cmake_path(GET targets STEM LAST_ONLY name)
  set(mended_directory "${CMAKE_CURRENT_BINARY_DIR}/mended")
  file(READ "${targets}" text)
  string(REGEX MATCHALL "get_filename_component\\(_IMPORT_PREFIX " levels "${text}")
  set(prefix "${targets}")
  foreach(level IN LISTS levels)
    cmake_path(GET prefix PARENT_PATH prefix)
  endforeach()

  set(is_wrong FALSE)
  file(GLOB configurations "${directory}/${name}-*.cmake")
  foreach(file IN LISTS configurations)
    file(READ "${file}" configuration)
    string(REGEX MATCHALL "/[^\"]+\\.so\"" modules "${configuration}")
    list(REMOVE_DUPLICATES modules)
    foreach(module IN LISTS modules)
      string(REGEX REPLACE "\\.so\"$" "" stem "${module}")
      file(GLOB there "${prefix}${stem}.*.so")
      if(there AND NOT EXISTS "${prefix}${stem}.so")
        set(is_wrong TRUE)
        cmake_path(GET there FILENAME there_name)
        cmake_path(GET stem PARENT_PATH folder)
        string(REPLACE "${module}" "${folder}/${there_name}\"" configuration "${configuration}")
      endif()
    endforeach()
    cmake_path(GET file FILENAME file_name)
    file(WRITE "${mended_directory}/${file_name}" "${configuration}")
  endforeach()
  if(is_wrong)
    string(REPLACE "\${CMAKE_CURRENT_LIST_FILE}" "${targets}" text "${text}")
    file(WRITE "${mended_directory}/${name}.cmake" "${text}")
    include("${mended_directory}/${name}.cmake")
    message(STATUS "${targets} names Python modules that are not there: mended for this build")
  endif()
endfunction()

# A macro, since packages set variables of whoever looks for them.
macro(foam_find_paraview)
  # No package has this version, but all that there are get listed.
  find_package(ParaView 0.0 EXACT QUIET)
  foreach(config version IN ZIP_LISTS ParaView_CONSIDERED_CONFIGS ParaView_CONSIDERED_VERSIONS)
    if(version VERSION_LESS 5.11)
      message(STATUS "ParaView ${version}: too old (${config})")
      continue()
    endif()
    cmake_path(GET config PARENT_PATH ParaView_DIR)
    file(GLOB vtk_targets "${ParaView_DIR}/vtk/VTKPython-targets.cmake")
    file(GLOB paraview_targets "${ParaView_DIR}/ParaViewPython*-targets.cmake")
    foreach(targets IN LISTS vtk_targets paraview_targets) # these refer to VTK's
      foam_mend_python_targets("${targets}")
    endforeach()
    break()
  endforeach()
  # With COMPONENTS only these modules' dependencies are asked for, not those of all of ParaView.
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingViews)
  message(STATUS "ParaView: found, ${ParaView_VERSION}, with VTK ${VTK_VERSION} (${ParaView_DIR})")
  # Modules that the plugin does not use link to these, which their package has not looked up.
  foreach(target hdf5::hdf5 hdf5::hdf5_hl NetCDF::NetCDF)
    if(NOT TARGET ${target})
      add_library(${target} INTERFACE IMPORTED)
    endif()
  endforeach()
endmacro()
