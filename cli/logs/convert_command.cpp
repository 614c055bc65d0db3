// `cls convert IN OUT`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "base/io/gzip_sink.h"
#include "cli/support/exit_code.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcg/record_writer.h"

namespace cls::cli {
namespace {

using gamelog::RcgVersion;

constexpr const char* kDescription =
    "convert a game log (rcg version 1 to 6 or JSON, plain or gzip) to another version\n"
    "\n"
    "  cls convert old.rcg.gz new.rcg             version 6\n"
    "  cls convert game.rcg game.rcg.gz --to 4    version 4, compressed\n"
    "  cls convert game.rcg game.json             JSON, by the name\n"
    "\n"
    "'-' is standard input or output. Of a corrupt log, the readable frames are converted.";

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

int run_convert_command(const Arguments& arguments) {
  const std::optional<RcgVersion> version = target_version(arguments);
  if (!version) {
    return print_error(kUsage, fmt::format("--to '{}': must be 4, 5, 6 or json", arguments.to));
  }
  const auto record = gamelog::read_rcg_file(arguments.in);
  if (!record) return print_error(kNoInput, record.error().message);
  report_errors(arguments.in, record->errors);
  if (record->frames() == 0 && !record->errors.empty()) return kBadData;

  auto sink = base::create_sink(arguments.out);
  if (!sink) return print_error(kCannotCreate, sink.error().message);
  gamelog::write_rcg(*record, *version, **sink);
  const auto closed = (*sink)->close();
  if (!closed) return print_error(kWriteFailed, closed.error().message);
  return record->errors.empty() ? kOk : kBadData;
}

}  // namespace

void add_convert_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("convert", kDescription);
  command->add_option("IN", arguments->in, "input game log")->required();
  command->add_option("OUT", arguments->out, "output game log, compressed if it ends in .gz")
      ->required();
  command->add_option("--to", arguments->to,
                      "version: 4, 5, 6 or json (default: 6, json for OUT.json)");
  command->callback([arguments, &exit_code] { exit_code = run_convert_command(*arguments); });
}

}  // namespace cls::cli
