// libFuzzer target: arbitrary bytes as a page, a stream or recorded decisions of the viewer.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/view_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cls::tests::check_view({reinterpret_cast<const char*>(data), size});
  return 0;
}
