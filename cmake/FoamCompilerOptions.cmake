# SPDX-License-Identifier: GPL-3.0-or-later
# foam_compiler_options(target): the warnings and sanitizers that all of our own code is held to.
#
# -Wrestrict warns falsely about string concatenation (GCC bug 105651).
#
# Contraction of a·b + c to a fused operation is off: results shall be the same bits wherever the
# same instructions run.
function(foam_compiler_options target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wconversion -Wshadow $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -ffp-contract=off
    $<$<BOOL:${FOAM_WARNINGS_AS_ERRORS}>:-Werror>)
  if(FOAM_SANITIZE)
    target_compile_options(${target} PRIVATE
      -fsanitize=${FOAM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${FOAM_SANITIZE})
  endif()
endfunction()
