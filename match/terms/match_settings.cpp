// Tables of parameters that matches decide or ignore.
#include "match/terms/match_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <variant>

#include "gamelog/rcg/rcg_writer.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;

struct Decided {
  std::string_view name;
  std::string_view instead;
};

constexpr std::string_view kPorts = "cls chooses the ports; --monitor-port N sets that of monitors";
constexpr std::string_view kLogPaths = "logs go to the match folder; use --dir";
constexpr std::string_view kTeams = "a team is a SIDE: team:DIR or run:COMMAND";

constexpr std::array kDecided = {
    Decided{"port", kPorts},
    Decided{"coach_port", kPorts},
    Decided{"olcoach_port", kPorts},
    Decided{"game_log_dir", kLogPaths},
    Decided{"game_log_fixed", kLogPaths},
    Decided{"game_log_fixed_name", kLogPaths},
    Decided{"game_log_dated", kLogPaths},
    Decided{"text_log_dir", kLogPaths},
    Decided{"text_log_fixed", kLogPaths},
    Decided{"text_log_fixed_name", kLogPaths},
    Decided{"text_log_dated", kLogPaths},
    Decided{"log_date_format", kLogPaths},
    Decided{"keepaway_log_dir", kLogPaths},
    Decided{"keepaway_log_fixed", kLogPaths},
    Decided{"keepaway_log_fixed_name", kLogPaths},
    Decided{"keepaway_log_dated", kLogPaths},
    Decided{"team_l_start", kTeams},
    Decided{"team_r_start", kTeams},
    Decided{"synch_mode", "use --mode synch or --mode realtime"},
    Decided{"auto_mode", "always on: a match starts when both teams have joined"},
    Decided{"connect_wait", "a match starts when both teams have joined; use --start-timeout"},
};

// On the embedded server, in any mode.
constexpr std::array<std::string_view, 7> kNoEffect = {
    "landmark_file",     "log_times",    "profile",         "verbose",
    "synch_micro_sleep", "send_vi_step", "sense_body_step",
};

// In lockstep there is no real time, and no keepaway log.
constexpr std::array<std::string_view, 3> kNoEffectInLockstep = {"recv_step", "slow_down_factor",
                                                                 "keepaway_logging"};

template <std::size_t size>
bool contains(const std::array<std::string_view, size>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Result<void> apply_match_setting(MatchOptions& options, std::string_view setting) {
  constexpr std::string_view kModule = "server::";
  if (setting.starts_with(kModule)) {
    const std::string_view name =
        setting.substr(kModule.size(), setting.find('=') - kModule.size());
    for (const Decided& row : kDecided) {
      if (name == row.name) {
        return Error{fmt::format("server::{} has no effect in a match: {}", name, row.instead)};
      }
    }
  }
  return apply_setting(options, setting);
}

std::vector<std::string> settings_without_effect(const MatchOptions& options) {
  std::vector<std::string> warnings;
  if (options.server_choice.kind != ServerChoice::Kind::kEmbedded) return warnings;
  const bool lockstep = mode_of(options) == MatchMode::kLockstep;
  const soccer::ServerParams defaults;
  for (const auto& row : soccer::server_param_table()) {
    const bool idle =
        contains(kNoEffect, row.name) || (lockstep && contains(kNoEffectInLockstep, row.name));
    const bool set = std::visit(
        [&](auto member) { return options.server.*member != defaults.*member; }, row.member);
    if (!idle || !set) continue;
    warnings.push_back(fmt::format("server::{} has no effect on the embedded server{}", row.name,
                                   contains(kNoEffect, row.name) ? "" : " in lockstep"));
  }
  return warnings;
}

bool is_log_parameter(std::string_view name) {
  constexpr std::array<std::string_view, 7> kWhatLogsHold = {
      "text_logging",     "game_logging",         "keepaway_logging",    "log_times",
      "game_log_version", "game_log_compression", "text_log_compression"};
  const bool names_files = std::any_of(
      kDecided.begin(), kDecided.end(),
      [name](const Decided& row) { return row.name == name && row.instead == kLogPaths; });
  return names_files || contains(kWhatLogsHold, name);
}

std::string length_problem(const soccer::ServerParams& server, std::optional<int> cycles,
                           std::string_view remedy) {
  const int half = server.half_time_cycles();
  if (half <= 0 && !cycles) {
    return fmt::format("server::half_time: without a limit of halves, {}", remedy);
  }
  // The trainer is the referee then.
  if (server.coach && !server.coach_w_referee && !cycles) {
    return fmt::format("server::coach=on: without a referee, {}", remedy);
  }
  const bool shoot_out = server.penalty_shoot_outs || server.keepaway;
  if (half > 0 && server.total_time_cycles() <= 0 && !shoot_out) {
    return "server::nr_normal_halfs: neither a half nor a shoot-out is played";
  }
  return "";
}

std::vector<std::string> log_setting_errors(const MatchOptions& options) {
  std::vector<std::string> errors;
  const int version = options.server.game_log_version;
  const bool lockstep = mode_of(options) == MatchMode::kLockstep;
  if (!gamelog::rcg_version(version)) {
    errors.push_back(
        fmt::format("server::game_log_version={}: must be 1 to 6, or -1 (JSON)", version));
  } else if (!lockstep && version >= 1 && version <= 3) {
    errors.push_back(fmt::format(
        "server::game_log_version={}: must be 4 to 6, or -1 (JSON), in mode {}; versions 1 to 3 "
        "need lockstep",
        version, name(mode_of(options))));
  }
  const std::pair<std::string_view, int> levels[] = {
      {"game_log_compression", options.server.game_log_compression},
      {"text_log_compression", options.server.text_log_compression}};
  for (const auto& [parameter, level] : levels) {
    if (level >= 0 && level <= 9) continue;
    errors.push_back(fmt::format("server::{}={}: must be 0 (plain) to 9", parameter, level));
  }
  return errors;
}

}  // namespace cls::match
