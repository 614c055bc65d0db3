// Team names of cls.toml and scripts of mock sides.
#include "cli/support/side_arguments.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/suggestion.h"
#include "cli/support/print_error.h"
#include "cli/support/tls_options.h"
#include "match/terms/endpoint.h"
#include "process/command_plan.h"
#include "tournament/config/config_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

bool is_endpoint(const std::string& side) {
  return side == "mock" || side.find(':') != std::string::npos;
}

std::string unknown(const std::string& side, const std::string& near, const fs::path& file,
                    const std::vector<std::string_view>& teams) {
  if (!near.empty()) {
    return fmt::format("unknown side '{}'; did you mean '{}'? (a team in {})", side, near,
                       file.string());
  }
  return fmt::format("unknown side '{}'; the teams in {} are {}; other sides: cls match --help",
                     side, file.string(), fmt::join(teams, ", "));
}

// The endpoint of the team `side`, for use in the working directory; `side` itself if there are no
// teams to mistake it for.
base::Result<std::string> endpoint_in(const TournamentConfig& config, const fs::path& file,
                                      const std::string& side) {
  if (const int team = team_index(config.competition, side); team >= 0) {
    return endpoint_from(config.execution.folder,
                         config.competition.teams[base::index(team)].endpoint);
  }

  std::vector<std::string_view> teams;
  for (const TeamEntry& team : config.competition.teams) teams.push_back(team.name);
  const std::string near(base::nearest_name(side, teams));
  const bool means_mock = near.empty() && !base::nearest_name(side, {"mock"}).empty();
  // parse_endpoint() knows what files mean, and lists the valid sides.
  const bool means_file = near.empty() && side.find_first_of("./{") != side.npos;
  if (teams.empty() || means_mock || means_file) return side;
  return base::Error{unknown(side, near, file, teams)};
}

// What `side` means where it is a folder; empty where it is none. The name of a project is a side
// inside of the project only.
std::string folder_meant(const std::string& side) {
  const fs::path folder(side);
  std::error_code code;
  if (!fs::is_directory(folder, code)) return "";

  if (const fs::path file = folder / "cls.toml"; !base::why_no_file(file)) {
    return fmt::format(
        "unknown side '{}': a folder with a cls.toml of its own; cd {} first, or --config {}", side,
        process::shell_quoted(side), process::shell_quoted(file.string()));
  }
  if (base::why_no_file(folder / "start") && base::why_no_file(folder / "start.sh")) return "";
  return fmt::format("unknown side '{0}'; did you mean 'team:{0}'?", side);
}

}  // namespace

int read_project(const fs::path& file, ParsedConfig& parsed, std::string_view label) {
  if (const auto why = base::why_no_file(file)) {
    return print_error(kNoInput, "{}{}: {}", label, file.string(), *why);
  }
  parsed = read_config(file);
  return parsed.errors.empty() ? kOk : print_errors(kBadConfig, parsed.errors);
}

int resolve_team_name(std::string& side, std::string& team_name, const std::string& config_file) {
  if (is_endpoint(side)) return kOk;

  std::error_code code;
  const std::optional<fs::path> file = config_file.empty() ? find_config(fs::current_path(code))
                                                           : std::optional<fs::path>(config_file);

  if (!file) return kOk;
  ParsedConfig parsed;
  TRY_STEP(read_project(*file, parsed));

  TRY_INIT_OR(kUsage, auto endpoint, endpoint_in(parsed.config, *file, side));
  if (team_name.empty() && endpoint != side) team_name = side;
  side = std::move(endpoint);
  return kOk;
}

base::Result<std::string> endpoint_of_team(const std::string& side, const fs::path& folder) {
  if (is_endpoint(side)) return side;
  const std::optional<fs::path> file = find_config(folder.empty() ? "." : folder);
  if (!file) return side;

  const ParsedConfig parsed = read_config(*file);
  if (!parsed.errors.empty()) return base::Error{parsed.errors.front()};
  return endpoint_in(parsed.config, *file, side);
}

std::optional<double> start_timeout_of_project() {
  std::error_code code;
  const std::optional<fs::path> file = find_config(fs::current_path(code));
  if (!file) return std::nullopt;

  const ParsedConfig parsed = read_config(*file);
  if (!parsed.errors.empty() || !parsed.config.conditions.options.contains("start_timeout")) {
    return std::nullopt;
  }
  return match_options(parsed.config.conditions).start_timeout_s;
}

base::Result<match::Endpoint> parse_side(const std::string& side, const std::string& config_file) {
  auto endpoint = match::parse_endpoint(side);
  if (!endpoint && config_file.empty()) {
    if (std::string meant = folder_meant(side); !meant.empty())
      return base::Error{std::move(meant)};
  }

  std::error_code code;
  if (endpoint || is_endpoint(side) || !config_file.empty() ||
      find_config(fs::current_path(code))) {
    return endpoint;
  }

  return base::Error{endpoint.error().message +
                     "; names of teams need a cls.toml here or above, or --config FILE"};
}

int read_side(const std::string& label, std::string text, const match::TlsFileNames& tls,
              match::Endpoint& side) {
  std::string team_name;
  TRY_STEP(resolve_team_name(text, team_name, ""));

  auto parsed = parse_side(text, "");
  if (!parsed) return print_error(kUsage, label + parsed.error().message);

  side = *std::move(parsed);
  TRY_STEP(read_tls_files(side, tls));
  return read_side_files(side);
}

int read_playmaker(const std::string& label, const std::string& text,
                   const match::TlsFileNames& tls, match::Endpoint& side) {
  TRY_STEP(read_side(label, text, tls, side));
  if (side.has_one_playmaker()) return kOk;

  return print_error(
      kUsage,
      label + (!side.policy_file.empty() ? "a policy is not a Playmaker; play it with cls match"
               : side.has_playmaker() ? "mix: and each: have several Playmakers; check each of them"
                                      : "team:DIR has no Playmaker"));
}

int read_side_files(match::Endpoint& side) {
  const auto loaded = load_files(side);
  if (loaded) return kOk;
  const bool exists = missing_file(side).empty();
  return print_error(exists ? kBadData : kNoInput, loaded.error().message);
}

int exit_code_of_book(const std::string& file) { return base::absence(file) ? kNoInput : kBadData; }

}  // namespace cls::cli
