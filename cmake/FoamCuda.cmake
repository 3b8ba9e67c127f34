# SPDX-License-Identifier: GPL-3.0-or-later
# Whether the GPU's part of the core is built: FOAM_CUDA_FOUND, and the language CUDA enabled; and
# whether it has a direct solver: FOAM_CUDSS_FOUND, and the target cudss.
# Kernels take minutes to compile for an architecture, so that they are for the GPU that is here; a
# package has those of all.
set(FOAM_CUDA AUTO CACHE STRING "Build for NVIDIA GPUs: ON; OFF; AUTO where a CUDA compiler is found \
and a GPU is here or named by CMAKE_CUDA_ARCHITECTURES; ALL for all where a CUDA compiler is found")
set_property(CACHE FOAM_CUDA PROPERTY STRINGS AUTO ON OFF ALL)

set(FOAM_CUDA_FOUND FALSE)
set(FOAM_CUDSS_FOUND FALSE)
if(FOAM_CUDA)
  find_program(CMAKE_CUDA_COMPILER nvcc HINTS ENV CUDACXX ENV CUDA_PATH PATHS /usr/local/cuda
    PATH_SUFFIXES bin)
  if(NOT CMAKE_CUDA_ARCHITECTURES AND EXISTS /dev/nvidia0 AND NOT FOAM_CUDA STREQUAL ALL)
    set(CMAKE_CUDA_ARCHITECTURES native)
  elseif(NOT CMAKE_CUDA_ARCHITECTURES AND NOT FOAM_CUDA STREQUAL AUTO)
    # Machine code for these, and PTX that the driver of a later one compiles.
    set(CMAKE_CUDA_ARCHITECTURES 75-real 80-real 86-real 89-real 90)
  endif()
  if(CMAKE_CUDA_COMPILER AND CMAKE_CUDA_ARCHITECTURES)
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
  elseif(CMAKE_CUDA_COMPILER)
    message(STATUS "A CUDA compiler, but no GPU here: without support for GPUs (FOAM_CUDA=ON builds it)")
  elseif(NOT FOAM_CUDA MATCHES "^(AUTO|ALL)$")
    message(FATAL_ERROR "FOAM_CUDA is on, but no CUDA compiler (nvcc) is found")
  else()
    message(STATUS "No CUDA compiler: without support for GPUs")
  endif()
endif()
