// Programs that the build has made.
#pragma once

#include <string>

namespace cls::tests {

/// The path of a fake or tool of this build. For test binaries, which are told CLS_BUILD_DIR.
inline std::string built(const std::string& name) {
  return std::string(CLS_BUILD_DIR) + "/bin/" + name;
}

}  // namespace cls::tests
