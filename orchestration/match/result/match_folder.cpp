// Creates the match folder and its manifest.
#include "orchestration/match/result/match_folder.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "base/system/host.h"
#include "base/system/version.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::orchestration::match {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;
using Json = nlohmann::ordered_json;

// Parameters that differ from their defaults.
template <typename Params>
void add_settings(Json& settings, std::string_view module, const Params& params,
                  const soccer::ParameterTable<Params>& table) {
  const Params defaults;
  for (const auto& row : table) {
    std::visit(
        [&](auto member) {
          if (params.*member == defaults.*member) return;
          settings[fmt::format("{}::{}", module, row.name)] = params.*member;
        },
        row.member);
  }
}

}  // namespace

Result<fs::path> make_match_folder(const MatchOptions& options, const TeamNames& names) {
  std::error_code code;
  if (!options.folder.empty()) {
    fs::create_directories(options.folder, code);
    if (code || !fs::is_directory(options.folder, code)) {
      const std::string why = code ? code.message() : "not a folder";
      return Error{fmt::format("cannot create folder {}: {}", options.folder.string(), why)};
    }
    return options.folder;
  }
  const std::string stem = fmt::format("{}-{}-vs-{}", base::utc_stamp(), names.left, names.right);
  fs::create_directories("runs", code);
  for (int attempt = 1; !code; ++attempt) {
    const fs::path folder =
        fs::path("runs") / (attempt == 1 ? stem : fmt::format("{}-{}", stem, attempt));
    if (fs::create_directory(folder, code)) return folder;
  }
  return Error{fmt::format("cannot create folder runs/{}: {}", stem, code.message())};
}

std::string manifest_json(const MatchOptions& options, const TeamNames& names, std::uint64_t seed) {
  const auto deadline = decision_deadline(options);
  Json settings = Json::object();
  add_settings(settings, "server", options.server, soccer::server_param_table());
  add_settings(settings, "player", options.player, soccer::player_param_table());
  const auto side = [](const std::string& team, const Endpoint& endpoint,
                       const std::vector<int>& cpus) {
    Json described = {{"name", team}, {"endpoint", endpoint.text}};
    if (!cpus.empty()) described["cpus"] = cpus;
    return described;
  };
  const Json document = {{"schema", "cls.manifest/1"},
                         {"started", base::utc_now()},
                         {"host", base::host_name()},
                         {"folder", fs::current_path().string()},
                         {"command", options.command_line},
                         {"cls", base::kVersion},
                         {"seed", seed},
                         {"left", side(names.left, options.left, options.left_cpus)},
                         {"right", side(names.right, options.right, options.right_cpus)},
                         {"coach", options.coach},
                         {"trainer", options.trainer ? Json(options.trainer->text) : Json(nullptr)},
                         {"cycles", options.cycles ? Json(*options.cycles) : Json(nullptr)},
                         {"protocol", options.protocol},
                         {"rpc_deadline_ms", deadline ? Json(deadline->count()) : Json(nullptr)},
                         {"server", options.server_choice.text},
                         {"mode", name(mode_of(options))},
                         {"settings", std::move(settings)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cls::orchestration::match
