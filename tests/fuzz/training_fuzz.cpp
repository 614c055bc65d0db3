// libFuzzer target: configurations, actions and calls of the C interface of the training engine.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/training_script.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cls::tests::play_training_script({reinterpret_cast<const char*>(data), size});
  return 0;
}
