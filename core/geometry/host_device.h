// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks the functions that a CUDA compiler also compiles for the GPU. They hold no containers but
// std::array, whose members are constexpr (nvcc --expt-relaxed-constexpr).
//
// A kernel that is written where it is used begins with FOAM_KERNEL, what it needs being copied
// (nvcc --extended-lambda, which wants the function around it to be no private member of a class).
//
// FOAM_APART marks those of these functions that are large beside a call, or that few elements
// need, such as what films do on walls: they are compiled once and called, where a compiler for
// GPUs would put them into every kernel, several times into those that sum.
#pragma once

#ifdef __CUDACC__
#define FOAM_HOST_DEVICE __host__ __device__
#else
#define FOAM_HOST_DEVICE
#endif
#define FOAM_APART FOAM_HOST_DEVICE __attribute__((noinline))
#define FOAM_KERNEL [=] FOAM_HOST_DEVICE
