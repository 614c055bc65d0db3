// Looks up embedded scripts.
#include "cli/shell/shells.h"

#include <algorithm>

namespace cls::cli {
namespace {

// "cls.bash" in the file names.
constexpr std::string_view kPrefix = "cls.";

}  // namespace

const std::vector<std::string_view>& shell_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const ShellScript& script : shell_scripts()) {
      all.push_back(script.name.substr(kPrefix.size()));
    }
    return all;
  }();
  return names;
}

const ShellScript* find_shell(std::string_view name) {
  const auto& scripts = shell_scripts();
  const auto found = std::ranges::find_if(
      scripts, [name](const ShellScript& one) { return one.name.substr(kPrefix.size()) == name; });
  return found == scripts.end() ? nullptr : &*found;
}

}  // namespace cls::cli
