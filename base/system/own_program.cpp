// Reads /proc/self/exe.
#include "base/system/own_program.h"

#include <fmt/format.h>

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
  return std::filesystem::path(path);
}

}  // namespace cls::base
