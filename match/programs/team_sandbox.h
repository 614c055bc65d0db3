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
/// `folder` contains it. `namespaces`: of a program in namespaces, with folders of its own for
/// temporary files and shared memory, and the links by which programs know folders.
process::FileAccess team_files(const std::filesystem::path& folder,
                               const std::vector<std::filesystem::path>& hidden,
                               bool namespaces = false);

/// The environment of a team: from the environment of cls the search paths of programs and
/// libraries, the user's name, home and shell, the language and the time zone.
std::vector<process::EnvironmentChange> team_environment();

/// True if the programs of that side start in namespaces: of an external team in a sandbox, on a
/// host that can make them, whose clients the match binds to their side.
bool has_namespaces(const MatchOptions& options, soccer::Side side);
/// True if they also have a network of their own: where the embedded server can have ports in it.
bool has_own_network(const MatchOptions& options, soccer::Side side);

/// Why a match that needs namespaces for its external teams cannot have them; empty: it can, or
/// does not need them.
std::string refused_without_namespaces(const MatchOptions& options);

/// That external teams run without the wanted sandbox on this host, or in half of one; empty: they
/// run in a whole one, or none is wanted.
std::string missing_sandbox(const MatchOptions& options);

/// Why the teams of a match are not, or not entirely, separated from its files and from each other:
/// one line each; empty without external teams and with --no-sandbox. Empty `match_folder`: none.
std::vector<std::string> sandbox_warnings(const MatchOptions& options,
                                          const std::filesystem::path& match_folder);

}  // namespace cls::match
