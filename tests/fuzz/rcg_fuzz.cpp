// libFuzzer target: arbitrary bytes as a game log.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/log_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cls::tests::check_game_log({reinterpret_cast<const char*>(data), size});
  return 0;
}
