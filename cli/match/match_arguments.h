// The arguments of `cls match` and `cls config`: options, settings of cls.toml, what they result
// in.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/match/program_options.h"
#include "cli/support/tls_options.h"
#include "orchestration/match/options/match_options.h"

namespace CLI {
class App;
}

namespace cls::cli {

/// Filled by CLI11; resolve_match() completes `options`.
struct MatchArguments {
  std::string left;
  std::string right;
  orchestration::match::MatchOptions options;
  std::optional<int> half_time;
  std::vector<std::string> settings;
  std::string on_late = "hold";
  std::string batch = "auto";
  std::string server = "embedded";
  std::string mode;
  TlsOptions tls;
  ProgramOptions programs;
  std::string trainer;
  std::string formation;
  std::string left_formation;
  std::string right_formation;
  bool dry_run = false;
  bool pin = false;
  std::string folder;
  std::string config_file;
  bool json = false;
  bool step = false;
  std::optional<int> at;
  std::string record_rpc;
  std::vector<std::string> save_at;  ///< CYCLE and FILE
  std::string resume;
  bool quiet = false;
  bool strict = false;
  bool watch = false;
  bool open = false;
  std::optional<double> linger_s;
  bool force = false;

  /// Where settings come from that have not their default value: "cls.toml:12", "option --seed".
  std::map<std::string, std::string> origins;
};

/// The options of a match; LEFT and RIGHT are the command's own.
void add_match_options(CLI::App& command, MatchArguments& arguments);

/// Names of teams and settings of cls.toml: built-in values yield to cls.toml, and these to the
/// options given. cls.toml counts if --config names it or if a side is a team in it. Prints errors;
/// returns kOk, kUsage, kNoInput, kBadData or kBadConfig.
int resolve_match(const CLI::App& command, MatchArguments& arguments);

/// A setting and where its value comes from.
struct SettingRow {
  std::string name;    ///< as in cls.toml, or server::NAME, player::NAME
  std::string value;   ///< empty: none
  std::string origin;  ///< "default", "cls.toml:12", "option --seed"
};

/// All settings of a resolved match.
std::vector<SettingRow> setting_rows(const MatchArguments& arguments);

}  // namespace cls::cli
