// `cls tournament run` for commands that play a tournament of their own.
#pragma once

#include <string>

namespace cls::cli {

/// Plays or resumes the tournament of `folder`/cls.toml, as `cls tournament run` does, but
/// prints no report; `quiet`: errors only. Returns its exit code.
int play_tournament(const std::string& folder, bool quiet);

}  // namespace cls::cli
