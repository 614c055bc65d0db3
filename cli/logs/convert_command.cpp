// `cls convert IN OUT`: any game log in; version 4, 5, 6 or JSON out.
#include "cli/logs/convert_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "base/io/gzip_sink.h"
#include "cli/support/damage_report.h"
#include "cli/support/exit_code.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcg/record_writer.h"

namespace cls::cli {
namespace {

using gamelog::RcgVersion;

constexpr const char* kDescription =
    "Converts a game log (rcg of version 1 to 6 or JSON, plain or gzip) into another version.\n"
    "\n"
    "  cls convert old.rcg.gz new.rcg             version 6\n"
    "  cls convert game.rcg game.rcg.gz --to 4    version 4, compressed\n"
    "  cls convert game.rcg game.json             JSON, by the name\n"
    "\n"
    "'-' is standard input or output. Of a damaged log, what can be read is converted.";

struct Arguments {
  std::string in;
  std::string out;
  std::string to;
};

std::optional<RcgVersion> target_version(const Arguments& arguments) {
  if (arguments.to.empty()) {
    const bool json = arguments.out.ends_with(".json") || arguments.out.ends_with(".json.gz");
    return json ? RcgVersion::kJson : RcgVersion::kV6;
  }
  if (arguments.to == "4") return RcgVersion::kV4;
  if (arguments.to == "5") return RcgVersion::kV5;
  if (arguments.to == "6") return RcgVersion::kV6;
  if (arguments.to == "json") return RcgVersion::kJson;
  return std::nullopt;
}

int fail(const base::Error& error, int code) {
  fmt::print(stderr, "cls: {}\n", error.message);
  return code;
}

int run_convert_command(const Arguments& arguments) {
  const std::optional<RcgVersion> version = target_version(arguments);
  if (!version) {
    fmt::print(stderr, "cls: --to '{}': must be 4, 5, 6 or json\n", arguments.to);
    return kUsage;
  }
  const auto record = gamelog::read_rcg_file(arguments.in);
  if (!record) return fail(record.error(), kNoInput);
  report_damage(arguments.in, record->damage);
  if (record->frames() == 0 && !record->damage.empty()) return kBadData;

  auto sink = base::create_sink(arguments.out);
  if (!sink) return fail(sink.error(), kCannotCreate);
  gamelog::write_rcg(*record, *version, **sink);
  const auto closed = (*sink)->close();
  if (!closed) return fail(closed.error(), kWriteFailed);
  return record->damage.empty() ? kDone : kBadData;
}

}  // namespace

void add_convert_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("convert", kDescription);
  command->add_option("IN", arguments->in, "game log to read")->required();
  command->add_option("OUT", arguments->out, "game log to write, compressed if it ends in .gz")
      ->required();
  command->add_option("--to", arguments->to, "version: 4, 5, 6 or json (6; json for OUT.json)");
  command->callback([arguments, &exit_code] { exit_code = run_convert_command(*arguments); });
}

}  // namespace cls::cli
