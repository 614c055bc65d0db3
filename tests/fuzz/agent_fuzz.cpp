// libFuzzer target: agent scripts on the agents of the proxy.
#include <cstdint>
#include <string_view>

#include "tests/fuzz/agent_script.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cls::tests::play_agent_script({reinterpret_cast<const char*>(data), size});
  return 0;
}
