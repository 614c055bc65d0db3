// Version numbers.
#pragma once

#include <string_view>

namespace cls::base {

extern const std::string_view kVersion;            ///< release of cls, set by CMake
extern const std::string_view kGitVersion;         ///< `git describe`; empty: not built from git
extern const std::string_view kCompiler;           ///< "GCC 13.2.0"
constexpr std::string_view kWireVersion = "1.10";  ///< of proto/playmaker.proto

}  // namespace cls::base
