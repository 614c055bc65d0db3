// libFuzzer target: arbitrary bytes as a table or a log of the trajectory challenge.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/table_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cls::tests::check_table({reinterpret_cast<const char*>(data), size});
  return 0;
}
