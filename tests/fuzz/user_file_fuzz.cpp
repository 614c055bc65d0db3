// libFuzzer target: the files that users write. The first byte selects the kind of file.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/user_file_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cls::tests::check_user_file({reinterpret_cast<const char*>(data), size});
  return 0;
}
