// Creates the match folder and its manifest.
#include "match/result/match_folder.h"

#include <fmt/format.h>
#include <google/protobuf/stubs/common.h>
#include <grpcpp/grpcpp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "base/system/version.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "match/result/match_result.h"
#include "match/terms/option_table.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Json;
using base::Result;

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

Json text_or_null(std::string_view text) { return text.empty() ? Json(nullptr) : Json(text); }

Json machine_json() {
  const base::Machine machine = base::this_machine();
  return {{"os", text_or_null(machine.os)},       {"kernel", text_or_null(machine.kernel)},
          {"cpu", text_or_null(machine.cpu)},     {"cores", machine.cores},
          {"memory_bytes", machine.memory_bytes}, {"load", base::load_average()}};
}

Json versions_json(const std::string& server) {
  return {{"cls", base::kVersion},
          {"commit", text_or_null(base::kGitVersion)},
          {"wire", base::kWireVersion},
          {"server", text_or_null(server)},
          {"protobuf", google::protobuf::internal::VersionString(GOOGLE_PROTOBUF_VERSION)},
          {"grpc", grpc::Version()},
          {"compiler", base::kCompiler}};
}

// Variables that change how cls, gRPC or a Playmaker runs.
Json environment_json() {
  constexpr std::array<std::string_view, 13> kPrefixes = {
      "CLS_",     "GRPC_",  "LANG=",          "LC_",           "LD_", "NO_COLOR=",   "OMP_",
      "OPENBLAS", "PYTHON", "RCSS_CONF_DIR=", "SLURM_JOB_ID=", "TZ=", "VIRTUAL_ENV="};
  Json variables = Json::object();
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view line = *entry;
    const bool matters =
        std::ranges::any_of(kPrefixes, [line](auto prefix) { return line.starts_with(prefix); });
    const std::size_t equals = line.find('=');
    if (matters && equals != std::string_view::npos) {
      variables[std::string(line.substr(0, equals))] = line.substr(equals + 1);
    }
  }
  return variables;
}

// Renames `path`, if the options allow it.
Result<void> make_way(const MatchOptions& options, const fs::path& path,
                      const std::string& problem) {
  if (!options.replace) {
    return Error{fmt::format("{} {}; choose another name, or --force to rename it to {}.old",
                             path.string(), problem, path.filename().string())};
  }
  TRY(base::set_aside(path));
  return {};
}

bool is_written_before_first_cycle(const fs::path& file) {
  const std::string name = file.filename().string();
  return name == kResultFile || name == kManifestFile || name == kEventsFile ||
         name.ends_with(".log");
}

// Removes what a match left that ended before its first cycle: then a command can be repeated.
// Leaves a folder alone that holds anything else.
void remove_match_that_never_began(const fs::path& folder) {
  const auto text = base::read_file(folder / kResultFile);
  if (!text) return;
  const auto result = parse_match_result(*text);
  if (!result || result->cycles > 0) return;

  std::error_code code;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    if (!entry.is_regular_file(code) || !is_written_before_first_cycle(entry.path())) return;
    files.push_back(entry.path());
  }
  for (const fs::path& file : files) fs::remove(file, code);
}

Result<void> keep_earlier_files(const MatchOptions& options) {
  std::error_code code;
  if (!options.folder.empty()) remove_match_that_never_began(options.folder);
  const std::string contents = base::contents_of(options.folder);
  if (!options.folder.empty() && !contents.empty()) {
    TRY(make_way(options, options.folder, "holds " + contents));
  }

  for (const fs::path& file : {options.record_rpc, options.save_file}) {
    if (!fs::is_regular_file(file, code)) continue;
    if (options.replace && fs::is_symlink(file, code)) continue;  // /dev/stdout: written into
    TRY(make_way(options, file, "exists"));
  }
  return {};
}

}  // namespace

// A folder of others may have a manifest.json of its own.
bool is_match_folder(const fs::path& folder) {
  std::error_code code;
  return fs::is_regular_file(folder / kEventsFile, code) &&
         fs::is_regular_file(folder / kManifestFile, code);
}

fs::path game_log_in(const fs::path& folder) {
  fs::path log = folder / kGameLogFile;
  std::error_code code;
  if (fs::exists(log, code)) return log;

  fs::path packed = log.string() + ".gz";
  return fs::exists(packed, code) ? packed : log;
}

bool has_result(const fs::path& folder) {
  std::error_code code;
  return fs::exists(folder / kResultFile, code);
}

Result<fs::path> make_match_folder(const MatchOptions& options, const TeamNames& names) {
  TRY(keep_earlier_files(options));
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
  std::error_code gone;
  if (fs::current_path(gone).empty() || gone) {
    return Error{
        "the working folder does not exist any more; go to another one, or select a folder for the "
        "match with --dir DIR"};
  }
  for (int attempt = 1; !code; ++attempt) {
    const fs::path folder =
        fs::path("runs") / (attempt == 1 ? stem : fmt::format("{}-{}", stem, attempt));
    if (fs::create_directory(folder, code)) return folder;
  }
  return Error{fmt::format("cannot create folder runs/{}: {}; --dir DIR selects another place",
                           stem, code.message())};
}

namespace {

// The value of each option in effect; options without a value are left out.
Json options_json(const MatchOptions& options) {
  Json described = Json::object();
  for (const MatchOption& option : match_options()) {
    std::string value = option.shown(options);
    if (!value.empty()) described[std::string(option.key)] = std::move(value);
  }
  return described;
}

}  // namespace

std::string manifest_json(const MatchOptions& options, const TeamNames& names, std::uint64_t seed,
                          const ManifestTimes& times) {
  const auto deadline = decision_deadline(options);

  Json settings = Json::object();
  add_settings(settings, "server", options.server, soccer::server_param_table());
  add_settings(settings, "player", options.player, soccer::player_param_table());
  const auto side = [&](soccer::Side which) {
    Json described = {{"name", names[which]}, {"endpoint", endpoint_of(options, which).text}};
    if (!options.cpus[which].empty()) described["cpus"] = options.cpus[which];
    return described;
  };

  const Json document = {{"schema", "cls.manifest/1"},
                         {"started", times.started},
                         {"ended", text_or_null(times.ended)},
                         {"host", base::host_name()},
                         {"machine", machine_json()},
                         {"environment", environment_json()},
                         {"folder", fs::current_path().string()},
                         {"command", options.command_line},
                         {"cls", base::kVersion},
                         {"versions", versions_json(times.server_version)},
                         {"seed", seed},
                         {"left", side(soccer::Side::kLeft)},
                         {"right", side(soccer::Side::kRight)},
                         {"coach", options.coach},
                         {"trainer", options.trainer ? Json(options.trainer->text) : Json(nullptr)},
                         {"cycles", options.cycles ? Json(*options.cycles) : Json(nullptr)},
                         {"protocol", options.protocol},
                         {"rpc_deadline_ms", deadline ? Json(deadline->count()) : Json(nullptr)},
                         {"server", options.server_choice.text},
                         {"mode", name(mode_of(options))},
                         {"options", options_json(options)},
                         {"settings", std::move(settings)}};
  return base::json_document(document);
}

}  // namespace cls::match
