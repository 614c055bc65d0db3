// Which release this is.
#pragma once

#include <string_view>

namespace cls::base {

extern const std::string_view kVersion;            ///< of cls, from CMake
constexpr std::string_view kWireVersion = "1.10";  ///< of proto/playmaker.proto

}  // namespace cls::base
