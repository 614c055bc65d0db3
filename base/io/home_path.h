// Paths that begin with a tilde.
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

/// "~/logs" and "~ada/logs" with the home folder, as a shell expands them in front of an argument,
/// but not behind `--dir=`, `team:` or `server::game_log_dir=`. Other text, and the name of an
/// unknown user, stay as they are.
std::string expand_home(std::string_view path);

}  // namespace cls::base
