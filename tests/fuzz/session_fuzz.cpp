// libFuzzer target: session scripts on the match server.
#include <cstdint>
#include <string_view>

#include "tests/fuzz/session_script.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cls::tests::play_session_script({reinterpret_cast<const char*>(data), size});
  return 0;
}
