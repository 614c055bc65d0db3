// The sandbox of external teams: what the programs of `team:DIR` can use of the host.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "match/terms/match_options.h"
#include "process/command_plan.h"

namespace cls::match {

/// The files of the team in `folder`: that folder to change, the folders of the system and those
/// that PATH and LD_LIBRARY_PATH name to read. What is in a folder of `hidden` is left out, unless
/// `folder` contains it.
process::FileAccess team_files(const std::filesystem::path& folder,
                               const std::vector<std::filesystem::path>& hidden);

/// The environment of a team: from the environment of cls the search paths of programs and
/// libraries, the user's name, home and shell, the language and the time zone.
std::vector<process::EnvironmentChange> team_environment();

/// That external teams run without a sandbox on this kernel, or in half of one; empty: they run in
/// a whole one.
std::string missing_sandbox();

/// Why the teams of a match are not, or not entirely, separated from its files and from each other:
/// one line each; empty without external teams and with --no-sandbox. Empty `match_folder`: none.
std::vector<std::string> sandbox_warnings(const MatchOptions& options,
                                          const std::filesystem::path& match_folder);

}  // namespace cls::match
