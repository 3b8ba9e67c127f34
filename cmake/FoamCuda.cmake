# SPDX-License-Identifier: GPL-3.0-or-later
# Whether the GPU's part of the core is built: FOAM_CUDA_FOUND, and the language CUDA enabled; and
# whether it has a direct solver: FOAM_CUDSS_FOUND, and the target cudss.
set(FOAM_CUDA AUTO CACHE STRING "Build for NVIDIA GPUs: ON, OFF, or AUTO where a CUDA compiler is found")
set_property(CACHE FOAM_CUDA PROPERTY STRINGS AUTO ON OFF)

set(FOAM_CUDA_FOUND FALSE)
set(FOAM_CUDSS_FOUND FALSE)
if(FOAM_CUDA)
  if(NOT CMAKE_CUDA_ARCHITECTURES)
    # Machine code for these, and PTX that the driver of a later one compiles.
    set(CMAKE_CUDA_ARCHITECTURES 75-real 80-real 86-real 89-real 90)
  endif()
  find_program(CMAKE_CUDA_COMPILER nvcc HINTS ENV CUDACXX ENV CUDA_PATH PATHS /usr/local/cuda
    PATH_SUFFIXES bin)
  if(CMAKE_CUDA_COMPILER)
    enable_language(CUDA)
    if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION) # which CMake before 3.26 does not know of nvcc
      set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
      set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20)
    endif()
    find_package(CUDAToolkit REQUIRED)
    set(FOAM_CUDA_FOUND TRUE)
    find_package(cudss CONFIG QUIET)
    if(cudss_FOUND AND cudss_VERSION VERSION_GREATER_EQUAL 0.8) # before, matrices were made otherwise
      set(FOAM_CUDSS_FOUND TRUE)
      message(STATUS "cuDSS: found, ${cudss_VERSION}")
    else()
      message(STATUS "cuDSS 0.8 or later: not found, without a direct solver on GPUs")
    endif()
  elseif(NOT FOAM_CUDA STREQUAL AUTO)
    message(FATAL_ERROR "FOAM_CUDA is on, but no CUDA compiler (nvcc) is found")
  else()
    message(STATUS "No CUDA compiler: without support for GPUs")
  endif()
endif()
