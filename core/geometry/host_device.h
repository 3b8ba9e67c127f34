// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks the functions that a CUDA compiler also compiles for the GPU. They hold no containers but
// std::array, whose members are constexpr (nvcc --expt-relaxed-constexpr).
//
// A kernel that is written where it is used begins with FOAM_KERNEL, what it needs being copied
// (nvcc
// --extended-lambda, which wants the function around it to be no private member of a class).
#pragma once

#ifdef __CUDACC__
#define FOAM_HOST_DEVICE __host__ __device__
#else
#define FOAM_HOST_DEVICE
#endif
#define FOAM_KERNEL [=] FOAM_HOST_DEVICE
