// The completion scripts of the shells. They call `cls complete`, so that they always fit the
// binary.
#pragma once

#include <string_view>
#include <vector>

namespace cls::cli {

/// A script of cli/shell/scripts, embedded at build time.
struct ShellScript {
  std::string_view name;  ///< of the shell: "bash"
  std::string_view text;
};
const std::vector<ShellScript>& shell_scripts();

/// "bash", "fish", "zsh".
const std::vector<std::string_view>& shell_names();

/// nullptr if the name is unknown.
const ShellScript* find_shell(std::string_view name);

}  // namespace cls::cli
