// SIDE arguments: team names of cls.toml and scripts of mock sides.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "match/terms/endpoint.h"
#include "match/terms/match_options.h"

namespace cls::tournament {
struct ParsedConfig;
}

namespace cls::cli {

/// Replaces a team name of cls.toml by the team's endpoint, and sets `team_name` if it is empty.
/// Reads `config_file`, or the cls.toml in or above the working directory. Leaves endpoints and
/// unknown names unchanged. Prints errors; returns kOk, kNoInput, kBadConfig or kUsage.
int resolve_team_name(std::string& side, std::string& team_name, const std::string& config_file);

/// The endpoint of a team that the cls.toml in `folder` or above names, for use in the working
/// directory; `side` itself without such a file, and if it is an endpoint. The error says which
/// teams there are.
base::Result<std::string> endpoint_of_team(const std::string& side,
                                           const std::filesystem::path& folder);

/// Reads a cls.toml. Prints errors, one for a missing file begins with `label` ("--config ");
/// returns kOk, kNoInput or kBadConfig.
int read_project(const std::filesystem::path& file, tournament::ParsedConfig& parsed,
                 std::string_view label = "");

/// Seconds that the cls.toml in or above the working directory gives its teams to start, and
/// perhaps to build; none without such a file, or if it leaves the time to the command.
std::optional<double> start_timeout_of_project();

/// parse_endpoint() for a side without its team name. The error says where names of teams come from
/// if there is no such file.
base::Result<match::Endpoint> parse_side(const std::string& side, const std::string& config_file);

/// Of a book that cannot be read: whether it is there.
int exit_code_of_book(const std::string& file);

/// The side that a command plays with or checks: an endpoint, or the name of a team of cls.toml;
/// with its files and certificates. Prints errors, which begin with `label` ("--against: ");
/// returns kOk, kUsage, kNoInput, kBadConfig or kBadData.
int read_side(const std::string& label, std::string text, const match::TlsFileNames& tls,
              match::Endpoint& side);

/// read_side() for a side that must have one Playmaker.
int read_playmaker(const std::string& label, const std::string& text,
                   const match::TlsFileNames& tls, match::Endpoint& side);

/// Reads the script of a mock side and the parameters of the planner, if the side has them. Prints
/// errors; returns kOk, kNoInput or kBadData.
int read_side_files(match::Endpoint& side);

}  // namespace cls::cli
