// Options of CLI11, and the order in which settings override each other.
#include "cli/match/match_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <variant>

#include "base/io/whole_file.h"
#include "base/text/byte_size.h"
#include "cli/logs/live_view.h"
#include "cli/support/command_line.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "cli/support/reply_options.h"
#include "cli/support/side_arguments.h"
#include "orchestration/match/options/match_settings.h"
#include "orchestration/match/options/saved_match.h"
#include "orchestration/tournament/config/config_file.h"
#include "player/formation/formation_set.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using orchestration::match::MatchOptions;
using orchestration::tournament::ParsedConfig;

// Deadlines of Playmakers and the handling of missed decisions.
void add_deadline_options(CLI::App& command, MatchArguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_option("--rpc-deadline", options.rpc_deadline_ms,
                     "deadline of an RPC in ms (default: lockstep 10000, synch 1000, "
                     "realtime 70)");
  command.add_flag("--no-deadline", options.no_deadline, "wait without limit (for debuggers)");
  add_reply_options(command, arguments.on_late, arguments.batch);
  command
      .add_option("--max-missed", options.max_missed,
                  "consecutive missed decisions of a player; one more ends the match "
                  "(default: 20)")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--reconnect-within", options.reconnect_within_s,
                     "seconds to wait for a disconnected Playmaker, where the server waits "
                     "(default: 3)");
  add_tls_options(command, arguments.tls);
}

void add_team_options(CLI::App& command, MatchArguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_option("--left-name", options.left_name, "team name of the left side");
  command.add_option("--right-name", options.right_name, "team name of the right side");
  command.add_flag("--rated", options.rated,
                   "refuse policies that were trained with the full state, as tournaments do");
  command.add_flag("--own-names", options.own_names, "allow external teams to use their own names");
  command.add_flag("--coach,!--no-coach", options.coach,
                   "connect an online coach for each cls team (default: on)");
  command.add_option("--trainer", arguments.trainer,
                     "SIDE whose Playmaker handles GetTrainerActions (default: none)");
  command.add_option("--formation", arguments.formation,
                     "folder with formations of cls teams, see docs/formations.md (default: "
                     "built-in)");
  command.add_option("--left-formation", arguments.left_formation, "--formation of the left side");
  command.add_option("--right-formation", arguments.right_formation,
                     "--formation of the right side");
}

void add_debugging_options(CLI::App& command, MatchArguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_flag("--step", arguments.step,
                   "wait for a line on stdin before each cycle (see docs/testing.md)");
  command.add_option("--at", arguments.at, "--step, starting at this game time")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--record-rpc", arguments.record_rpc,
                  "record all requests and replies in FILE (see cls test --replay)")
      ->type_name("FILE");
  command.add_flag("--record-world-models", options.record_world_models,
                   "record what each player estimates, receives and sends; cls watch then\n"
                   "shows it beside the full state (docs/watching.md)");
  command
      .add_option("--save-at", arguments.save_at,
                  "save the match in FILE when game time reaches CYCLE (docs/matches.md)")
      ->type_name("CYCLE FILE")
      ->expected(2);
  command
      .add_option("--resume", arguments.resume,
                  "continue the match saved in FILE; with --seed its random draws differ from "
                  "there on")
      ->type_name("FILE");
  command.add_option("--monitor-port", options.monitor_port,
                     "UDP port for monitors; 0 selects a free port and prints it");
}

}  // namespace

void add_match_options(CLI::App& command, MatchArguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_option("--seed", options.seed,
                     "random seed; the same seed repeats the match (default: random, printed)");
  command.add_option("--cycles", options.cycles, "end the match at this game time");
  command.add_option("--half-time", arguments.half_time,
                     "length of a half in seconds (default: 300)");
  add_team_options(command, arguments);
  command.add_option("--dir", arguments.folder,
                     "match folder (default: ./runs/<UTC>-<left>-vs-<right>)");
  command.add_flag("--force", arguments.force,
                   "rename an existing --dir, --record-rpc or --save-at file to NAME.old");
  command.add_option(
      "--config", arguments.config_file,
      "cls.toml with teams and settings (default: for the name of a team, the one in or "
      "above the working directory)");
  command.add_flag("--json", arguments.json, "print only the result document");
  command.add_option("--set", arguments.settings, "server::NAME=VALUE, repeatable")
      ->expected(1)
      ->take_all();
  command
      .add_option("--server", arguments.server,
                  "embedded, rcssserver, PATH of a server, or HOST:PORT")
      ->capture_default_str();
  command
      .add_option("--mode", arguments.mode,
                  "lockstep, synch or realtime (default: lockstep; synch with an external "
                  "server or team)")
      ->check(CLI::IsMember({"lockstep", "synch", "realtime"}));
  command.add_flag("--pin", arguments.pin, "give each side half of the processor cores");
  command.add_flag("--dry-run", arguments.dry_run, "print the commands without starting anything");
  add_deadline_options(command, arguments);
  command.add_option("--start-timeout", options.start_timeout_s,
                     "seconds until the first response of a Playmaker (default: 20)");
  command.add_option("--stall-after", options.stall_after_s,
                     "seconds without a new cycle that end the match (default: 10)");
  command.add_option("--time-limit", options.time_limit_s,
                     "maximum seconds of the match (default: no limit)");
  add_program_options(command, arguments.programs);
  add_sandbox_option(command, options.sandbox);
  add_debugging_options(command, arguments);
  command
      .add_option("--speed", options.speed, "limit speed to X times real time (default: no limit)")
      ->type_name("X");
  command.add_option("--protocol", options.protocol,
                     "protocol version of cls agents, 14 to 19 (default: 18)");
  command.add_flag("--watch", arguments.watch,
                   "serve a page that shows the match while it is played, and print its "
                   "address (docs/watching.md)");
  command.add_flag("--open", arguments.open, "--watch, and open the page in the browser");
  add_linger_option(command, arguments.linger_s);
  command.add_flag("--strict", arguments.strict, "fail (exit 1) on any warning");
  command.add_flag("--quiet", arguments.quiet, "print no progress and no warnings");
}

namespace {

void read_formation_options(MatchArguments& arguments, std::vector<std::string>& errors) {
  const auto read = [&](const std::string& folder, const char* option,
                        std::shared_ptr<const player::FormationSet>& out) {
    if (folder.empty()) return;
    if (auto set = player::read_formations(folder)) {
      out = std::move(*set);
    } else {
      errors.push_back(fmt::format("{}: {}", option, set.error().message));
    }
  };
  read(arguments.formation, "--formation", arguments.options.left_formations);
  arguments.options.right_formations = arguments.options.left_formations;
  read(arguments.left_formation, "--left-formation", arguments.options.left_formations);
  read(arguments.right_formation, "--right-formation", arguments.options.right_formations);
}

void read_save_at(MatchArguments& arguments, std::vector<std::string>& errors) {
  if (arguments.save_at.empty()) return;
  const std::string& text = arguments.save_at.front();
  const char* end = text.data() + text.size();
  int cycle = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, cycle);
  if (stop != end || error != std::errc()) {
    const bool too_large = stop == end && error == std::errc::result_out_of_range;
    errors.push_back(fmt::format("--save-at '{}': {}", text,
                                 too_large ? "too large" : "must be a cycle, then a file"));
    return;
  }
  arguments.options.save_at = cycle;
  arguments.options.save_file = arguments.save_at.back();
}

// Sets the options from the arguments; returns all errors.
std::vector<std::string> resolve(MatchArguments& arguments) {
  std::vector<std::string> errors;
  MatchOptions& options = arguments.options;
  const auto read_side = [&](const std::string& text, orchestration::match::Endpoint& endpoint) {
    const auto parsed = parse_side(text, arguments.config_file);
    if (parsed) {
      endpoint = *parsed;
    } else {
      errors.push_back(parsed.error().message);
    }
  };
  read_side(arguments.left, options.left);
  read_side(arguments.right, options.right);
  if (!arguments.trainer.empty()) read_side(arguments.trainer, options.trainer.emplace());
  const auto server = orchestration::match::parse_server(arguments.server);
  if (server) options.server_choice = *server;
  if (!server) errors.push_back(server.error().message);
  if (!arguments.mode.empty()) {
    const auto mode = orchestration::match::parse_mode(arguments.mode);
    if (mode) options.mode = *mode;
    if (!mode) errors.push_back(mode.error().message);
  }
  options.on_late = proxy::parse_on_late(arguments.on_late).value_or(options.on_late);
  options.batch = proxy::parse_batch_mode(arguments.batch).value_or(options.batch);
  read_formation_options(arguments, errors);
  if (arguments.half_time) options.server.half_time = *arguments.half_time;
  for (const std::string& setting : arguments.settings) {
    const auto applied = apply_match_setting(options, setting);
    if (!applied) errors.push_back("--set: " + applied.error().message);
  }
  read_save_at(arguments, errors);
  read_program_options(arguments.programs, options, errors);
  options.folder = arguments.folder;
  options.replace = arguments.force;
  options.command_line = command_line();
  if (arguments.pin) {
    const auto pinned = pin_sides(options);
    if (!pinned) errors.push_back(pinned.error().message);
  }
  options.record_rpc = arguments.record_rpc;
  options.step = arguments.step || arguments.at;
  for (std::string& error : validate_options(options)) errors.push_back(std::move(error));
  return errors;
}

// True if a side was the name of a team in cls.toml.
struct ResolvedNames {
  int exit_code = kOk;
  bool any = false;
};

ResolvedNames resolve_names(MatchArguments& arguments) {
  MatchOptions& options = arguments.options;
  const bool names_given = !options.left_name.empty() || !options.right_name.empty();
  const std::string written[] = {arguments.left, arguments.right, arguments.trainer};
  const int left = resolve_team_name(arguments.left, options.left_name, arguments.config_file);
  if (left != kOk) return {left, false};
  std::string trainer_name;
  const int trainer = arguments.trainer.empty() ? kOk
                                                : resolve_team_name(arguments.trainer, trainer_name,
                                                                    arguments.config_file);
  if (trainer != kOk) return {trainer, false};
  const int right = resolve_team_name(arguments.right, options.right_name, arguments.config_file);
  // Names of cls.toml need not match the names that external teams connect with.
  const bool named = !options.left_name.empty() || !options.right_name.empty();
  if (named && !names_given) {
    options.own_names = true;
    arguments.origins["own_names"] = "team of cls.toml";
  }
  const bool any = written[0] != arguments.left || written[1] != arguments.right ||
                   written[2] != arguments.trainer;
  return {right, any};
}

// "--rpc-deadline" -> "rpc_deadline", the name of a setting.
std::string setting_name(std::string option) {
  option.erase(0, option.find_first_not_of('-'));
  std::replace(option.begin(), option.end(), '-', '_');
  return option;
}

// Values of the environment count as given, although the command line lacks them.
bool is_from_environment(const CLI::App& command, const CLI::Option* option) {
  const std::vector<CLI::Option*>& parsed = command.parse_order();
  return std::find(parsed.begin(), parsed.end(), option) == parsed.end();
}

void note_options(const CLI::App& command, MatchArguments& arguments) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    const bool positional = option->get_lnames().empty();
    const std::string& name = positional ? option->get_name() : option->get_lnames().front();
    std::string setting = setting_name(name);
    if (positional) {
      setting = name == "LEFT" ? "left" : "right";
      arguments.origins[setting] = "argument " + name;
      continue;
    }
    if (setting == "half_time") setting = "server::half_time";
    arguments.origins[setting] = is_from_environment(command, option)
                                     ? "environment " + option->get_envname()
                                     : "option --" + name;
  }
  if (arguments.options.no_deadline) arguments.origins["rpc_deadline"] = "option --no-deadline";
  for (const std::string& setting : arguments.settings) {
    arguments.origins[setting.substr(0, setting.find('='))] = "option --set";
  }
}

// Stores a value of cls.toml unless an option has set it.
class ConfigValues {
 public:
  ConfigValues(const ParsedConfig& parsed, std::string file, MatchArguments& arguments)
      : parsed_(parsed), file_(std::move(file)), arguments_(arguments) {}

  template <typename Value, typename Member>
  void take(const std::string& key, const Value& value, Member& member) {
    if (claim(key, key)) member = value;
  }
  // The first setting of a name wins: options came before.
  bool claim(const std::string& key, const std::string& setting) {
    const auto line = parsed_.lines.find(key);
    if (line == parsed_.lines.end()) return false;
    return arguments_.origins.emplace(setting, fmt::format("{}:{}", file_, line->second)).second;
  }

 private:
  const ParsedConfig& parsed_;
  std::string file_;
  MatchArguments& arguments_;
};

// A path of a server is relative to the folder of the teams.
std::string server_from(const fs::path& folder, const std::string& server) {
  const bool is_relative_path = server.find('/') != std::string::npos && server.front() != '/';
  return is_relative_path ? (folder / server).lexically_normal().string() : server;
}

int take_config(const ParsedConfig& parsed, const fs::path& file, MatchArguments& arguments) {
  const orchestration::tournament::TournamentConfig& config = parsed.config;
  MatchOptions& options = arguments.options;
  std::error_code code;
  const fs::path shown = fs::proximate(file, code);
  ConfigValues values(parsed, code ? file.string() : shown.string(), arguments);
  for (const auto& setting : config.settings) {
    if (!values.claim(setting.name, setting.name)) continue;
    const auto applied = apply_match_setting(options, setting.name + "=" + setting.value);
    if (!applied) return print_error(kBadConfig, applied.error().message);
  }
  if (values.claim("half_time", "server::half_time")) options.server.half_time = *config.half_time;
  values.take("seed", config.seed, options.seed);
  values.take("cycles", config.cycles, options.cycles);
  values.take("mode", config.mode, arguments.mode);
  values.take("server", server_from(config.folder, config.server), arguments.server);
  values.take("rpc_deadline", config.rpc_deadline_ms, options.rpc_deadline_ms);
  values.take("max_missed", config.max_missed.value_or(0), options.max_missed);
  values.take("start_timeout", config.start_timeout_s.value_or(0), options.start_timeout_s);
  values.take("stall_after", config.stall_after_s.value_or(0), options.stall_after_s);
  values.take("time_limit", config.time_limit_s, options.time_limit_s);
  values.take("max_memory", config.max_memory.value_or(0), options.limits.memory);
  values.take("sandbox", config.sandbox, options.sandbox);
  values.take("max_cpu", config.max_cpu_s.value_or(0), options.limits.cpu_seconds);
  return kOk;
}

int read_config_file(MatchArguments& arguments, bool names_used) {
  std::error_code code;
  fs::path file = arguments.config_file;
  if (file.empty() && names_used) {
    const auto found = orchestration::tournament::find_config(fs::current_path(code));
    if (found) file = *found;
  }
  if (file.empty()) return kOk;
  if (const auto why = base::why_no_file(file)) {
    return print_error(kNoInput, fmt::format("--config {}: {}", file.string(), *why));
  }
  const ParsedConfig parsed = orchestration::tournament::read_config(file);
  if (!parsed.errors.empty()) return print_errors(kBadConfig, parsed.errors);
  return take_config(parsed, file, arguments);
}

// The saved match replaces the parameters; a seed of cls.toml is not that of a branch.
int resume(MatchArguments& arguments) {
  if (arguments.resume.empty()) return kOk;
  if (arguments.half_time || !arguments.settings.empty()) {
    return print_error(kUsage,
                       "--resume: the parameters are those of the saved match; no --set, no "
                       "--half-time");
  }
  if (const auto why = base::why_no_file(arguments.resume)) {
    return print_error(kNoInput, fmt::format("--resume {}: {}", arguments.resume, *why));
  }
  const auto match = orchestration::match::read_saved_match(arguments.resume);
  if (!match) return print_error(kBadData, "--resume " + match.error().message);
  MatchOptions& options = arguments.options;
  if (arguments.origins["seed"] != "option --seed") options.seed.reset();
  const auto resumed = orchestration::match::resume_from(*match, options);
  if (!resumed) return print_error(kBadData, "--resume: " + resumed.error().message);
  const std::vector<std::string> errors = validate_options(options);
  return errors.empty() ? kOk : print_errors(kUsage, errors);
}

template <typename Value>
std::string shown(const std::optional<Value>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::string shown(bool value) { return value ? "true" : "false"; }

template <typename Params>
void add_parameters(std::vector<SettingRow>& rows, std::string_view module, const Params& params,
                    const soccer::ParameterTable<Params>& table) {
  for (const auto& row : table) {
    std::visit(
        [&](auto member) {
          rows.push_back(
              {fmt::format("{}::{}", module, row.name), fmt::format("{}", params.*member), ""});
        },
        row.member);
  }
}

}  // namespace

int resolve_match(const CLI::App& command, MatchArguments& arguments) {
  const ResolvedNames names = resolve_names(arguments);
  if (names.exit_code != kOk) return names.exit_code;
  note_options(command, arguments);
  if (const int read = read_config_file(arguments, names.any); read != kOk) return read;
  const std::vector<std::string> errors = resolve(arguments);
  if (!errors.empty()) return print_errors(kUsage, errors);
  if (const int resumed = resume(arguments); resumed != kOk) return resumed;
  std::vector<orchestration::match::Endpoint*> sides = {&arguments.options.left,
                                                        &arguments.options.right};
  if (arguments.options.trainer) sides.push_back(&*arguments.options.trainer);
  for (orchestration::match::Endpoint* side : sides) {
    if (const int read = read_side_files(*side); read != kOk) return read;
    if (const int read = read_tls_files(*side, arguments.tls); read != kOk) return read;
  }
  return kOk;
}

std::vector<SettingRow> setting_rows(const MatchArguments& arguments) {
  const MatchOptions& options = arguments.options;
  const auto deadline = decision_deadline(options);
  const auto [memory, cpu] = options.limits;
  std::vector<SettingRow> rows = {
      {"left", options.left.text, ""},
      {"right", options.right.text, ""},
      {"left_name", options.left_name, ""},
      {"right_name", options.right_name, ""},
      {"own_names", shown(options.own_names), ""},
      {"rated", shown(options.rated), ""},
      {"seed", options.seed ? fmt::to_string(*options.seed) : "random", ""},
      {"cycles", shown(options.cycles), ""},
      {"mode", std::string(name(mode_of(options))), ""},
      {"server", options.server_choice.text, ""},
      {"rpc_deadline", deadline ? fmt::to_string(deadline->count()) : "", ""},
      {"no_deadline", shown(options.no_deadline), ""},
      {"on_late", arguments.on_late, ""},
      {"batch", arguments.batch, ""},
      {"max_missed", fmt::to_string(options.max_missed), ""},
      {"reconnect_within", fmt::format("{}", options.reconnect_within_s), ""},
      {"tls_ca", arguments.tls.authorities, ""},
      {"tls_cert", arguments.tls.certificate, ""},
      {"tls_key", arguments.tls.key, ""},
      {"tls_name", arguments.tls.server_name, ""},
      {"start_timeout", fmt::format("{}", options.start_timeout_s), ""},
      {"stall_after", fmt::format("{}", options.stall_after_s), ""},
      {"time_limit", shown(options.time_limit_s), ""},
      {"max_memory", memory == 0 ? "" : base::byte_size_text(memory), ""},
      {"sandbox", shown(options.sandbox), ""},
      {"max_cpu", cpu == 0 ? "" : fmt::to_string(cpu), ""},
      {"pin", shown(arguments.pin), ""},
      {"coach", shown(options.coach), ""},
      {"trainer", arguments.trainer, ""},
      {"formation", arguments.formation, ""},
      {"left_formation", arguments.left_formation, ""},
      {"right_formation", arguments.right_formation, ""},
      {"protocol", fmt::to_string(options.protocol), ""},
      {"speed", shown(options.speed), ""},
      {"monitor_port", shown(options.monitor_port), ""},
      {"record_rpc", options.record_rpc.string(), ""},
      {"record_world_models", shown(options.record_world_models), ""},
      {"save_at", fmt::format("{}", fmt::join(arguments.save_at, " ")), ""},
      {"resume", arguments.resume, ""},
      {"dir", options.folder.string(), ""},
  };
  add_parameters(rows, "server", server_params(options), soccer::server_param_table());
  add_parameters(rows, "player", options.player, soccer::player_param_table());
  for (SettingRow& row : rows) {
    const auto origin = arguments.origins.find(row.name);
    row.origin = origin == arguments.origins.end() ? "default" : origin->second;
  }
  return rows;
}

}  // namespace cls::cli
