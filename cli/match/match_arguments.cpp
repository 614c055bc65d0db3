// The order in which settings override each other.
#include "cli/match/match_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <string_view>
#include <system_error>
#include <variant>

#include "base/io/whole_file.h"
#include "cli/logs/live_view.h"
#include "cli/support/command_line.h"
#include "cli/support/match_option.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/support/tls_options.h"
#include "match/saved/saved_match.h"
#include "match/terms/match_settings.h"
#include "tournament/config/config_file.h"

namespace cls::cli {
namespace fs = std::filesystem;
using namespace match;
using tournament::ParsedConfig;

void add_match_options(Command& command, MatchArguments& arguments) {
  for (const MatchOption& row : match_options()) add_match_option(command, row);

  command.flag("--force", arguments.force,
               "rename an existing --dir, --record-rpc or --save-at file to NAME.old");
  command.option("--config FILE", arguments.config_file,
                 "cls.toml with teams and settings (default: for the name of a team, the one in "
                 "or above the working directory)");

  command.option("--set NAME=VALUE", arguments.settings, "server::NAME=VALUE, repeatable")
      .repeatable();
  command.flag("--dry-run", arguments.dry_run, "print the commands without starting anything")
      .of_group(kDebuggingGroup);
  command
      .flag("--step", arguments.step,
            "wait for a line on stdin before each cycle (see docs/testing.md)")
      .of_group(kDebuggingGroup);

  command.option("--at", arguments.at, "--step, starting at this game time")
      .of_group(kDebuggingGroup)
      .from(0);

  command
      .flag("--watch", arguments.watch,
            "serve a page that shows the match while it is played, and print its "
            "address (docs/watching.md)")
      .of_group(kOutputGroup);

  command.flag("--open", arguments.open, "--watch, and open the page in the browser")
      .of_group(kOutputGroup);
  add_host_name_option(command, arguments.host_names);
  add_linger_option(command, arguments.linger_s);
  command
      .option("--on-event COMMAND", arguments.on_event,
              "command at start, goal, half time, end and failure; gets the event as JSON on "
              "stdin and as variables CLS_EVENT, CLS_TEXT, ... (docs/tournaments.md)")
      .of_group(kOutputGroup);
  command
      .setting("--hook-limit", arguments.hook_limit_s,
               "seconds for a command of --on-event, and for all at the end")
      .of_group(kOutputGroup)
      .above(0);
  command.flag("--json", arguments.json, "print only the result document").of_group(kOutputGroup);
  command.flag("--strict", arguments.strict, "fail (exit 1) on any warning").of_group(kOutputGroup);
  command.flag("--quiet", arguments.quiet, "print no progress and no warnings")
      .of_group(kOutputGroup);
}

namespace {

// Sets the options from the arguments; returns all errors.
std::vector<std::string> resolve(MatchArguments& arguments) {
  std::vector<std::string> errors;
  MatchOptions& options = arguments.options;
  const auto read_side = [&](const std::string& text, match::Endpoint& endpoint) {
    const auto parsed = parse_side(text, arguments.config_file);
    if (parsed) {
      endpoint = *parsed;
    } else {
      errors.push_back(parsed.error().message);
    }
  };

  read_side(arguments.left, options.left);
  read_side(arguments.right, options.right);
  for (std::string& error : set_options(options, arguments.texts)) {
    errors.push_back(std::move(error));
  }
  for (const std::string& setting : arguments.settings) {
    const auto applied = apply_match_setting(options, setting);
    if (!applied) errors.push_back("--set: " + applied.error().message);
  }

  options.replace = arguments.force;
  options.command_line = command_line();
  if (options.pin) {
    const auto pinned = pin_sides(options);
    if (!pinned) errors.push_back(pinned.error().message);
  }

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
  OptionTexts& texts = arguments.texts;
  const bool names_given = texts.contains("left_name") || texts.contains("right_name");
  std::string names[2];
  ResolvedNames resolved;

  const auto resolve = [&](std::string& side, std::string& name) {
    const std::string written = side;
    const int code = resolve_team_name(side, name, arguments.config_file);
    if (resolved.exit_code == kOk) resolved.exit_code = code;
    resolved.any = resolved.any || side != written;
  };

  resolve(arguments.left, names[0]);
  for (const MatchOption& row : match_options()) {
    std::string name_of_side;
    const auto text = texts.find(row.key);
    if (row.is_side && text != texts.end()) resolve(text->second, name_of_side);
  }
  resolve(arguments.right, names[1]);

  // Names of cls.toml need not match the names that external teams connect with.
  if (!names[0].empty()) texts.emplace("left_name", names[0]);
  if (!names[1].empty()) texts.emplace("right_name", names[1]);
  const bool named = !names[0].empty() || !names[1].empty();
  if (named && !names_given) {
    texts["own_names"] = "true";
    arguments.origins["own_names"] = "team of cls.toml";
  }
  return resolved;
}

// The row of `cls config` that shows an option.
std::string shown_row(const MatchOption& option) {
  return std::string(option.shown_as.empty() ? option.key : option.shown_as);
}

void note_options(const Command& command, MatchArguments& arguments) {
  for (const char* side : {"LEFT", "RIGHT"}) {
    if (find_option(command, side)->given.empty()) continue;
    arguments.origins[side == std::string_view("LEFT") ? "left" : "right"] =
        fmt::format("argument {}", side);
  }

  for (const MatchOption& row : match_options()) {
    const std::string name = option_name(row.key);
    const Option& option = *find_option(command, name);
    if (option.given.empty()) continue;
    arguments.texts[std::string(row.key)] = fmt::format("{}", fmt::join(option.given, " "));
    arguments.origins[shown_row(row)] =
        option.from_environment ? "environment " + option.environment : "option " + name;
  }

  if (arguments.texts.contains("no_deadline")) {
    arguments.origins["rpc_deadline"] = "option --no-deadline";
  }
  for (const std::string& setting : arguments.settings) {
    arguments.origins[setting.substr(0, setting.find('='))] = "option --set";
  }
}

// A path of a server is relative to the folder of the teams.
std::string server_from(const fs::path& folder, const std::string& server) {
  const bool is_relative_path = server.find('/') != std::string::npos && server.front() != '/';
  return is_relative_path ? (folder / server).lexically_normal().string() : server;
}

// The first setting of a name wins: options came before cls.toml.
int take_config(const ParsedConfig& parsed, const fs::path& file, MatchArguments& arguments) {
  std::error_code code;
  const fs::path relative = fs::proximate(file, code);
  const std::string shown = code ? file.string() : relative.string();
  const auto claim = [&](std::string_view key, const std::string& setting) {
    const auto line = parsed.lines.find(std::string(key));
    return line != parsed.lines.end() &&
           arguments.origins.emplace(setting, fmt::format("{}:{}", shown, line->second)).second;
  };

  for (const auto& setting : parsed.config.conditions.settings) {
    if (!claim(setting.name, setting.name)) continue;
    TRY_OR(kBadConfig, apply_match_setting(arguments.options, setting.name + "=" + setting.value));
  }
  for (const MatchOption& row : match_options()) {
    const auto text = parsed.config.conditions.options.find(row.key);
    if (text == parsed.config.conditions.options.end() || !claim(row.key, shown_row(row))) continue;
    arguments.texts[std::string(row.key)] =
        row.key == "server" ? server_from(parsed.config.execution.folder, text->second)
                            : text->second;
  }

  if (claim("seed", "seed"))
    arguments.texts["seed"] = fmt::to_string(parsed.config.competition.seed);
  return kOk;
}

int read_config_file(MatchArguments& arguments, bool names_used) {
  std::error_code code;
  fs::path file = arguments.config_file;
  if (file.empty() && names_used) {
    const auto found = tournament::find_config(fs::current_path(code));
    if (found) file = *found;
  }
  if (file.empty()) return kOk;

  ParsedConfig parsed;
  TRY_STEP(read_project(file, parsed, "--config "));
  return take_config(parsed, file, arguments);
}

// The saved match replaces the parameters; a seed of cls.toml is not that of a branch.
int resume(MatchArguments& arguments) {
  MatchOptions& options = arguments.options;
  const std::string file = options.resume.string();
  if (file.empty()) return kOk;

  if (arguments.texts.contains("half_time") || !arguments.settings.empty()) {
    return print_error(kUsage,
                       "--resume: the parameters are those of the saved match; no --set, no "
                       "--half-time");
  }

  if (const auto why = base::why_no_file(file)) {
    return print_error(kNoInput, "--resume {}: {}", file, *why);
  }
  const auto match = match::read_saved_match(file);
  if (!match) return print_error(kBadData, "--resume " + match.error().message);

  if (arguments.origins["seed"] != "option --seed") options.seed.reset();
  const auto resumed = match::resume_from(*match, options);
  if (!resumed) return print_error(kBadData, "--resume: " + resumed.error().message);
  const std::vector<std::string> errors = validate_options(options);
  return errors.empty() ? kOk : print_errors(kUsage, errors);
}

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

int resolve_match(const Command& command, MatchArguments& arguments) {
  note_options(command, arguments);
  const ResolvedNames names = resolve_names(arguments);
  if (names.exit_code != kOk) return names.exit_code;
  TRY_STEP(read_config_file(arguments, names.any));
  const std::vector<std::string> errors = resolve(arguments);
  if (!errors.empty()) return print_errors(kUsage, errors);
  TRY_STEP(resume(arguments));
  if (const auto loaded = match::load_book(arguments.options); !loaded) {
    return print_error(exit_code_of_book(arguments.options.book),
                       "--book: " + loaded.error().message);
  }

  std::vector<match::Endpoint*> sides = {&arguments.options.left, &arguments.options.right};
  if (arguments.options.trainer) sides.push_back(&*arguments.options.trainer);
  for (match::Endpoint* side : sides) {
    TRY_STEP(read_side_files(*side));
    TRY_STEP(read_tls_files(*side, arguments.options.tls));
  }

  return kOk;
}

std::vector<SettingRow> setting_rows(const MatchArguments& arguments) {
  const MatchOptions& options = arguments.options;
  std::vector<SettingRow> rows = {{"left", options.left.text, ""},
                                  {"right", options.right.text, ""}};
  for (const MatchOption& row : match_options()) {
    if (row.shown_as.empty()) rows.push_back({std::string(row.key), row.shown(options), ""});
  }
  add_parameters(rows, "server", server_params(options), soccer::server_param_table());
  add_parameters(rows, "player", options.player, soccer::player_param_table());

  for (SettingRow& row : rows) {
    const auto origin = arguments.origins.find(row.name);
    row.origin = origin == arguments.origins.end() ? "default" : origin->second;
  }
  return rows;
}

}  // namespace cls::cli
