// The command line of rcssserver from parameters.
#include "match/programs/server_plan.h"

#include <fmt/format.h>

#include <type_traits>
#include <variant>

#include "base/text/value_text.h"
namespace cls::match {
namespace {

// In cycles; longer than any start limit.
constexpr int kConnectWait = 1'000'000;

// As rcssserver reads it.
template <class Value>
std::string text_of(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return value ? "on" : "off";
  } else {
    return base::text_of(value);
  }
}

// The user's parameters with those that the match needs.
soccer::ServerParams decided(const ServerSetup& setup) {
  soccer::ServerParams params = setup.server;
  params.auto_mode = true;
  params.synch_mode = setup.mode != MatchMode::kRealtime;
  params.port = setup.ports.player;
  params.coach_port = setup.ports.trainer;
  params.olcoach_port = setup.ports.coach;
  params.connect_wait = kConnectWait;
  params.game_log_dir = params.text_log_dir = "./";
  params.game_log_fixed = params.text_log_fixed = true;
  params.game_log_fixed_name = params.text_log_fixed_name = "match";

  // The match follows this log; convert_server_logs() makes the one that the user wants.
  params.game_logging = true;
  params.game_log_version = soccer::ServerParams().game_log_version;
  params.game_log_compression = params.text_log_compression = 0;
  params.game_log_dated = params.text_log_dated = false;
  return params;
}

template <typename Params>
void add_differences(std::vector<std::string>& argv, const std::string& module,
                     const Params& params, const soccer::ParameterTable<Params>& table) {
  const Params stock;
  for (const auto& row : table) {
    std::visit(
        [&](auto member) {
          if (params.*member == stock.*member) return;

          constexpr bool kIsText =
              std::is_same_v<std::remove_cvref_t<decltype(params.*member)>, std::string>;
          const std::string name = fmt::format("{}::{}", module, row.name);
          for (std::string& word : server_argument(name, text_of(params.*member), kIsText)) {
            argv.push_back(std::move(word));
          }
        },
        row.member);
  }
}

}  // namespace

std::vector<std::string> server_argument(const std::string& name, const std::string& value,
                                         bool is_text) {
  if (!is_text) return {name + "=" + value};
  const char quote = value.find('\'') == std::string::npos ? '\'' : '"';
  const std::string quoted = quote + value + quote;
  // rcssserver adds quotes to an argument with spaces that is not quoted as a whole.
  if (value.find_first_of(" \t\n") == std::string::npos) return {name + "=" + quoted};
  return {name + "=", quoted};
}

std::vector<process::EnvironmentChange> server_environment(const std::filesystem::path& folder) {
  std::vector<process::EnvironmentChange> environment;
  environment.push_back({"RCSS_CONF_DIR", (folder / kServerConfiguration).string()});
  // With these it would find, and rename, the configuration of old versions in the user's home.
  for (const char* name : {"USER", "USERNAME"}) environment.push_back({name, std::nullopt});
  return environment;
}

process::CommandPlan server_plan(const ServerSetup& setup) {
  process::CommandPlan plan;
  plan.name = "soccer server";
  plan.argv = setup.program;
  plan.folder = setup.folder;
  plan.log = setup.folder / kServerLog;
  plan.cpus = setup.cpus;
  plan.environment = server_environment(setup.folder);

  add_differences(plan.argv, "server", decided(setup), soccer::server_param_table());
  // `cls server` started by a match defaults to synch mode.
  if (setup.mode == MatchMode::kRealtime) plan.argv.push_back("server::synch_mode=off");
  add_differences(plan.argv, "player", setup.player, soccer::player_param_table());
  return plan;
}

}  // namespace cls::match
