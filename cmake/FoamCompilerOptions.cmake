# SPDX-License-Identifier: GPL-3.0-or-later
# foam_compiler_options(target): the warnings and sanitizers that all of our own code is held to.
#
# -Wrestrict warns falsely about string concatenation (GCC bug 105651).
#
# Contraction of a·b + c to a fused operation is off: results shall be the same bits wherever the
# same instructions run.
#
# nvcc hands the warnings on to the host's compiler, and compiles functions that are constexpr for
# the device, too (std::array's, for example).
function(foam_compiler_options target)
  set(warnings -Wall -Wextra -Wconversion -Wshadow)
  set(cxx "$<COMPILE_LANGUAGE:CXX>")
  set(cuda "$<COMPILE_LANGUAGE:CUDA>")
  list(JOIN warnings "," cuda_warnings)
  target_compile_options(${target} PRIVATE
    "$<${cxx}:${warnings};-ffp-contract=off>"
    "$<$<AND:${cxx},$<CXX_COMPILER_ID:GNU>>:-Wno-restrict>"
    "$<$<AND:${cxx},$<BOOL:${FOAM_WARNINGS_AS_ERRORS}>>:-Werror>"
    "$<${cuda}:--expt-relaxed-constexpr;--extended-lambda;--fmad=false;-Xcompiler=${cuda_warnings},-ffp-contract=off>"
    "$<$<AND:${cuda},$<BOOL:${FOAM_WARNINGS_AS_ERRORS}>>:-Werror=all-warnings>")
  if(FOAM_SANITIZE)
    target_compile_options(${target} PRIVATE
      -fsanitize=${FOAM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${FOAM_SANITIZE})
  endif()
endfunction()
