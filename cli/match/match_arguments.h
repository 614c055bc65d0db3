// The arguments of `cls match` and `cls config`: options, settings of cls.toml, what they result
// in.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/command/command.h"
#include "match/terms/option_table.h"
#include "process/hook_runner.h"

namespace cls::cli {

/// Arguments of the command line alone; resolve_match() completes `options`.
struct MatchArguments {
  std::string left;
  std::string right;
  match::MatchOptions options;
  match::OptionTexts texts;           ///< of options and cls.toml
  std::vector<std::string> settings;  ///< server::NAME=VALUE
  std::string config_file;
  bool dry_run = false;
  bool force = false;
  bool step = false;
  std::optional<int> at;
  bool json = false;
  bool quiet = false;
  bool strict = false;
  bool watch = false;
  bool open = false;
  std::optional<double> linger_s;
  std::vector<std::string> host_names;
  std::string on_event;
  double hook_limit_s = process::kHookLimit.count();

  /// Where settings come from that have not their default value: "cls.toml:12", "option --seed".
  std::map<std::string, std::string> origins;
};

/// The options of a match; LEFT and RIGHT are the command's own.
void add_match_options(Command& command, MatchArguments& arguments);

/// Names of teams and settings of cls.toml: built-in values yield to cls.toml, and these to the
/// options given. cls.toml counts if --config names it or if a side is a team in it. Prints errors;
/// returns kOk, kUsage, kNoInput, kBadData or kBadConfig.
int resolve_match(const Command& command, MatchArguments& arguments);

/// A setting and where its value comes from.
struct SettingRow {
  std::string name;    ///< as in cls.toml, or server::NAME, player::NAME
  std::string value;   ///< empty: none
  std::string origin;  ///< "default", "cls.toml:12", "option --seed"
};

/// All settings of a resolved match.
std::vector<SettingRow> setting_rows(const MatchArguments& arguments);

}  // namespace cls::cli
