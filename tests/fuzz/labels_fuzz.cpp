// SPDX-License-Identifier: GPL-3.0-or-later
#include "one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foam::test::read_labels({data, size});
  return 0;
}
