// The release number, given by CMake.
#include "orchestration/version.h"

namespace cls::orchestration {

const std::string_view kVersion = CLS_VERSION;

}  // namespace cls::orchestration
