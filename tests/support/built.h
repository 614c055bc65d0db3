// Programs of this build.
#pragma once

#include <string>

namespace cls::tests {

/// Path of a fake or tool of this build. Only for test binaries, which define CLS_BUILD_DIR.
inline std::string built(const std::string& name) {
  return std::string(CLS_BUILD_DIR) + "/bin/" + name;
}

}  // namespace cls::tests
