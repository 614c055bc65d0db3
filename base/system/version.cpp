// The release version, set by CMake.
#include "base/system/version.h"

namespace cls::base {

const std::string_view kVersion = CLS_VERSION;

}  // namespace cls::base
