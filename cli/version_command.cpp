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
#include <string>

#include "base/system/version.h"
#include "base/text/json.h"
#include "base/text/stored_formats.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/json_stdout.h"
#include "proto/recording_file.h"
#include "proto/saved_match_file.h"
#include "soccer/protocol/protocol_version.h"
#include "viewer/decisions/decision_writer.h"
#include "viewer/stream/chunk.h"

namespace cls::cli {
namespace {

constexpr const char* kVersionDescription =
    "print the version\n"
    "\n"
    "  cls version           of cls, its wire, its files and its libraries\n"
    "  cls version --json    for bug reports and scripts";

struct VersionArguments {
  bool json = false;
};

// "1.74.0" from 107400.
std::string dotted(int number, int step) {
  return fmt::format("{}.{}.{}", number / step / step, number / step % step, number % step);
}

std::string boost_version() {
  return fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                     BOOST_VERSION % 100);
}

base::Json document() {
  base::Json versions = {
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
        {"nlohmann-json", base::Json::library_version()},
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

int print_version(const VersionArguments& arguments) {
  const base::Json versions = document();
  if (arguments.json) {
    return print_json(versions);
  }

  fmt::print("cls {}\n", base::kVersion);
  const auto row = [](const std::string& name, const base::Json& version) {
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
  auto [command, arguments] = app.command("version", kVersionDescription, print_version);
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
