// The sandbox of external teams: what the programs of `team:DIR` can use of the host.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
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

/// Puts a program that works in `folder` into the sandbox, as far as this host has one: with
/// team_files() and team_environment(), which replace what it would inherit.
void put_in_sandbox(process::CommandPlan& plan, const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& hidden, bool namespaces);

/// Of `command`, a Playmaker's, the folder that it may change in the sandbox: that of the script
/// `run` that it starts, else the working directory.
std::filesystem::path playmaker_folder(std::string_view command);
/// As put_in_sandbox(), with namespaces, for the Playmaker that `command` starts in the working
/// directory; without its content if that is not in playmaker_folder().
void put_playmaker_in_sandbox(process::CommandPlan& plan, std::string_view command,
                              const std::vector<std::filesystem::path>& hidden);

/// True if the programs of that side are Playmakers that start in namespaces.
bool has_sandboxed_playmakers(const MatchOptions& options, soccer::Side side);
/// The commands of the Playmakers that cls starts for a side: one, or those of its parts.
std::vector<std::string> playmaker_commands(const Endpoint& side);
/// What Playmakers of a side may not see, wherever it is: the match folder, the other team.
std::vector<std::filesystem::path> hidden_from_playmakers(const MatchOptions& options,
                                                          soccer::Side side,
                                                          const std::filesystem::path& folder);

/// True if the programs of that side start in namespaces, with a network of their own: of an
/// external team in a sandbox, on a host that can make them, whose clients the match binds to their
/// side.
bool has_namespaces(const MatchOptions& options, soccer::Side side);

/// Why a match that needs namespaces for its external teams or Playmakers cannot have them; empty:
/// it can, or does not need them.
std::string refused_without_namespaces(const MatchOptions& options);

/// That external teams run without the wanted sandbox on this host, or in half of one; empty: they
/// run in a whole one, or none is wanted.
std::string missing_sandbox(const MatchOptions& options);

/// Why the teams of a match are not, or not entirely, separated from its files and from each other:
/// one line each; empty without external teams and with --no-sandbox. Empty `match_folder`: none.
std::vector<std::string> sandbox_warnings(const MatchOptions& options,
                                          const std::filesystem::path& match_folder);

}  // namespace cls::match
