// Reads /proc/self/exe.
#include "base/system/own_program.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace cls::base {

Result<std::filesystem::path> own_program() {
  constexpr const char* kLink = "/proc/self/exe";
  constexpr std::string_view kReplaced = " (deleted)";  // added by the kernel

  std::error_code code;
  std::string path = std::filesystem::read_symlink(kLink, code).string();
  if (code) return Error{fmt::format("{}: cannot read: {}", kLink, code.message())};
  if (path.ends_with(kReplaced)) path.resize(path.size() - kReplaced.size());

  // A script of `cls package-team` has started the loader with this program as its argument.
  const char* script = std::getenv("CLS_PROGRAM");
  if (script != nullptr && std::filesystem::path(path).filename().string().starts_with("ld-")) {
    return std::filesystem::path(script);
  }
  return std::filesystem::path(path);
}

}  // namespace cls::base
