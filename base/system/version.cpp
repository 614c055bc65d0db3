// The release version, set by CMake, and the commit of the build.
#include "base/system/version.h"

#include <git_version.h>

namespace cls::base {

const std::string_view kVersion = CLS_VERSION;
const std::string_view kGitVersion = CLS_GIT_VERSION;

#if defined(__clang__)
const std::string_view kCompiler = __VERSION__;
#else
const std::string_view kCompiler = "GCC " __VERSION__;
#endif

}  // namespace cls::base
