// Tables of parameters that matches decide or ignore.
#include "match/terms/match_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "base/text/split.h"
#include "gamelog/rcg/rcg_writer.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;

template <class Names>
bool lists(const Names& names, std::string_view name) {
  return std::ranges::find(names, name) != std::end(names);
}

constexpr std::string_view kLogPaths = "logs go to the match folder; use --dir";

struct Decided {
  std::string_view names;  ///< separated by blanks
  std::string_view instead;
};

constexpr Decided kDecided[] = {
    {"port coach_port olcoach_port",
     "cls chooses the ports; --monitor-port N sets that of monitors"},
    {"game_log_dir game_log_fixed game_log_fixed_name game_log_dated text_log_dir text_log_fixed "
     "text_log_fixed_name text_log_dated log_date_format keepaway_log_dir keepaway_log_fixed "
     "keepaway_log_fixed_name keepaway_log_dated",
     kLogPaths},
    {"team_l_start team_r_start", "a team is a SIDE: team:DIR or run:COMMAND"},
    {"synch_mode", "use --mode synch or --mode realtime"},
    {"auto_mode", "always on: a match starts when both teams have joined"},
    {"connect_wait", "a match starts when both teams have joined; use --start-timeout"},
};

// The alternative to setting a parameter of the server; empty: it may be set.
std::string_view instead_of(std::string_view name) {
  for (const Decided& row : kDecided) {
    if (lists(base::split(row.names, ' '), name)) return row.instead;
  }
  return {};
}

// On the embedded server, in any mode.
constexpr std::string_view kNoEffect[] = {
    "landmark_file",     "log_times",    "profile",         "verbose",
    "synch_micro_sleep", "send_vi_step", "sense_body_step",
};

// In lockstep there is no real time, and no keepaway log.
constexpr std::string_view kNoEffectInLockstep[] = {"recv_step", "slow_down_factor",
                                                    "keepaway_logging"};

}  // namespace

Result<void> apply_match_setting(MatchOptions& options, std::string_view setting) {
  constexpr std::string_view kModule = "server::";
  if (setting.starts_with(kModule)) {
    const std::string_view name =
        setting.substr(kModule.size(), setting.find('=') - kModule.size());
    const std::string_view instead = instead_of(name);
    if (!instead.empty()) {
      return Error{fmt::format("server::{} has no effect in a match: {}", name, instead)};
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
        lists(kNoEffect, row.name) || (lockstep && lists(kNoEffectInLockstep, row.name));
    const bool set = std::visit(
        [&](auto member) { return options.server.*member != defaults.*member; }, row.member);
    if (!idle || !set) continue;

    warnings.push_back(fmt::format("server::{} has no effect on the embedded server{}", row.name,
                                   lists(kNoEffect, row.name) ? "" : " in lockstep"));
  }
  return warnings;
}

bool is_log_parameter(std::string_view name) {
  constexpr std::string_view kWhatLogsHold[] = {
      "text_logging",     "game_logging",         "keepaway_logging",    "log_times",
      "game_log_version", "game_log_compression", "text_log_compression"};
  return instead_of(name) == kLogPaths || lists(kWhatLogsHold, name);
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
