// libFuzzer target: arbitrary bytes as a text log.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/log_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cls::tests::check_text_log({reinterpret_cast<const char*>(data), size});
  return 0;
}
