// `cls version`.
#include "cli/support/commands.h"

#include <fmt/format.h>
#include <google/protobuf/stubs/common.h>
#include <grpcpp/version_info.h>
#include <openssl/opensslv.h>
#include <sleef.h>
#include <sqlite3.h>
#include <toml++/toml.h>
#include <zlib.h>
#include <CLI/Version.hpp>

#include <boost/version.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/system/version.h"
#include "base/text/json_text.h"
#include "base/text/stored_formats.h"
#include "cli/support/exit_code.h"
#include "proto/recording_file.h"
#include "proto/saved_match_file.h"
#include "soccer/protocol/protocol_version.h"
#include "viewer/decisions/decision_writer.h"
#include "viewer/stream/chunk.h"

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "print the version\n"
    "\n"
    "  cls version           of cls, its wire, its files and its libraries\n"
    "  cls version --json    for bug reports and scripts";

// "1.74.0" from 107400.
std::string dotted(int number, int step) {
  return fmt::format("{}.{}.{}", number / step / step, number / step % step, number % step);
}

std::string boost_version() {
  return fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                     BOOST_VERSION % 100);
}

nlohmann::ordered_json document() {
  nlohmann::ordered_json versions = {
      {"schema", "cls.version/1"},
      {"cls", base::kVersion},
      {"wire", base::kWireVersion},
      {"commit", nullptr},
      {"compiler", base::kCompiler},
      {"protocol",
       {{"oldest", soccer::kMinProtocolVersion}, {"newest", soccer::kMaxProtocolVersion}}},
      {"formats",
       {{"match", base::kMatchSchema},
        {"scenario", base::kScenarioSchema},
        {"page", viewer::kViewSchema},
        {"decisions", viewer::kDecisionsSchema},
        {"cls.toml", fmt::to_string(base::kConfigSchema)},
        {"tune.toml", fmt::to_string(base::kTuneSchema)},
        {"planner.toml", fmt::to_string(base::kPlannerSchema)},
        {"tournament.db", fmt::to_string(base::kStoreSchema)},
        {"rpc-recording", fmt::to_string(proto::kRecordingVersion)},
        {"saved-match", fmt::to_string(proto::kSavedMatchVersion)}}},
      {"libraries",
       {{"boost", boost_version()},
        {"cli11", CLI11_VERSION},
        {"fmt", dotted(FMT_VERSION, 100)},
        {"grpc", GRPC_CPP_VERSION_STRING},
        {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                      NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
        {"openssl", OPENSSL_VERSION_STR},
        {"protobuf", dotted(GOOGLE_PROTOBUF_VERSION, 1000)},
        {"sleef", fmt::format("{}.{}.{}", SLEEF_VERSION_MAJOR, SLEEF_VERSION_MINOR,
                              SLEEF_VERSION_PATCHLEVEL)},
        {"sqlite", SQLITE_VERSION},
        {"tomlplusplus", fmt::format("{}.{}.{}", TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
        {"zlib", ZLIB_VERSION}}}};
  if (!base::kGitVersion.empty()) versions["commit"] = base::kGitVersion;
  return versions;
}

int print_version(bool json) {
  const nlohmann::ordered_json versions = document();
  if (json) {
    fmt::print("{}", base::json_document(versions));
    return kOk;
  }

  fmt::print("cls {}\n", base::kVersion);
  const auto row = [](const std::string& name, const nlohmann::ordered_json& version) {
    fmt::print("  {:<14} {}\n", name, version.get<std::string>());
  };
  row("wire", versions["wire"]);
  if (!versions["commit"].is_null()) row("commit", versions["commit"]);
  row("compiler", versions["compiler"]);
  row("protocol",
      fmt::format("{} to {}", soccer::kMinProtocolVersion, soccer::kMaxProtocolVersion));

  for (const auto& [name, version] : versions["formats"].items()) row(name, version);
  for (const auto& [name, version] : versions["libraries"].items()) row(name, version);
  return kOk;
}

}  // namespace

void add_version_command(Command& app) {
  const auto json = std::make_shared<bool>(false);
  Command& command = app.command("version", kDescription);
  command.flag("--json", *json, "print one JSON document");
  command.run = [json] { return print_version(*json); };
}

}  // namespace cls::cli
