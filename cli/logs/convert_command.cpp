// `cls convert IN OUT`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/io/gzip_sink.h"
#include "base/text/json_text.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "gamelog/rcg/record_writer.h"
#include "viewer/page/page.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using gamelog::RcgVersion;

constexpr const char* kDescription =
    "convert a game log to another version\n"
    "Reads rcg versions 1 to 6 and JSON, plain or gzip, and pages of 'cls watch'.\n"
    "\n"
    "  cls convert old.rcg.gz new.rcg             version 6\n"
    "  cls convert game.rcg game.rcg.gz --to 4    version 4, compressed\n"
    "  cls convert game.rcg game.json             JSON, by the name\n"
    "  cls convert page.html game.rcg             the log of the page, as it was\n"
    "\n"
    "'-' is standard input or output. Of a corrupt log, the readable frames are\n"
    "converted.";

struct Arguments {
  std::string in;
  std::string out;
  std::string to;
  bool json = false;
  bool force = false;
};

// False for a value of --to that no log can be written in.
bool parse_target(const std::string& to, std::optional<RcgVersion>& version) {
  if (to == "4") version = RcgVersion::kV4;
  if (to == "5") version = RcgVersion::kV5;
  if (to == "6") version = RcgVersion::kV6;
  if (to == "json") version = RcgVersion::kJson;
  return to.empty() || version.has_value();
}

// Without --to the name decides; a page gives the log back in its own version.
RcgVersion default_target(const std::string& out, const viewer::StreamMatch& match) {
  if (out.ends_with(".json") || out.ends_with(".json.gz")) return RcgVersion::kJson;
  return match.from_page ? std::max(match.record.version, RcgVersion::kV4) : RcgVersion::kV6;
}

void print_document(const Arguments& arguments, RcgVersion version,
                    const gamelog::MatchRecord& record) {
  nlohmann::ordered_json document = {
      {"schema", "cls.convert/1"}, {"in", arguments.in},
      {"out", arguments.out},      {"version", static_cast<int>(version)},
      {"frames", record.frames()}, {"errors", record.errors.count}};
  if (version == RcgVersion::kJson) document["version"] = "json";
  fmt::print("{}", base::json_document(document));
}

// Where OUT is written until it is complete: beside it, with its ending. Standard output, devices
// and links are written directly.
fs::path partial_file(const fs::path& out) {
  std::error_code code;
  const fs::file_type type = fs::symlink_status(out, code).type();
  const bool renamed = type == fs::file_type::regular || type == fs::file_type::not_found;
  if (out == "-" || !renamed) return out;
  return out.parent_path() / ("partial-" + out.filename().string());
}

// Leaves a complete OUT or what was there before. Returns the exit code.
int write_log(const gamelog::MatchRecord& record, RcgVersion version, const fs::path& out) {
  const fs::path partial = partial_file(out);
  const std::atomic<int>& signal = watch_interrupts();
  auto sink = base::create_sink(partial.string());
  if (!sink) {
    return print_error(kCannotCreate,
                       fmt::format("cannot create '{}': {}", out.string(), std::strerror(errno)));
  }
  gamelog::write_rcg(record, version, **sink);
  const auto closed = (*sink)->close();
  std::error_code code;
  if (partial == out) return closed ? kOk : print_error(kWriteFailed, closed.error().message);
  if (closed && signal == 0) {
    fs::rename(partial, out, code);
    if (!code) return kOk;
  }
  std::error_code ignored;
  fs::remove(partial, ignored);
  if (!closed) return print_error(kWriteFailed, closed.error().message);
  if (!code) return signal_exit_code(signal);
  return print_error(kCannotCreate,
                     fmt::format("cannot create '{}': {}", out.string(), code.message()));
}

int run_convert_command(const Arguments& arguments) {
  std::optional<RcgVersion> target;
  if (!parse_target(arguments.to, target)) {
    return print_error(kUsage, fmt::format("--to '{}': must be 4, 5, 6 or json", arguments.to));
  }
  if (arguments.json && arguments.out == "-") {
    return print_error(kUsage, "--json: OUT is stdout already; name a file");
  }
  std::error_code code;
  if (!arguments.force && std::filesystem::is_regular_file(arguments.out, code)) {
    return print_error(kCannotCreate,
                       fmt::format("{}: exists; use --force to replace it", arguments.out));
  }
  const auto match = viewer::read_log_or_page(arguments.in);
  if (!match) return print_error(unreadable_code(arguments.in), match.error().message);
  if (match->form.compact) {
    return print_error(kBadData, fmt::format("{}: a compact page, which is not a log; write it "
                                             "without --compact",
                                             arguments.in));
  }
  const gamelog::MatchRecord& record = match->record;
  const RcgVersion version = target ? *target : default_target(arguments.out, *match);
  report_errors(arguments.in, record.errors);
  if (record.frames() == 0 && !record.errors.empty()) return kBadData;

  if (const int written = write_log(record, version, arguments.out); written != kOk) {
    return written;
  }
  if (arguments.json) print_document(arguments, version, record);
  return record.errors.empty() ? kOk : kBadData;
}

}  // namespace

void add_convert_command(Command& app) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = app.command("convert", kDescription);
  command.group = kResultCommands;
  command.option("IN", arguments->in, "input game log").required();
  command.option("OUT", arguments->out, "output game log, compressed if it ends in .gz").required();
  command.option("--to", arguments->to,
                 "version: 4, 5, 6 or json (default: 6, json for OUT.json, that of\n"
                 "the log for a page)");
  command.flag("--force", arguments->force, "replace an existing OUT");
  command.flag("--json", arguments->json, "print frames and errors as one JSON document");
  command.run = [arguments] { return run_convert_command(*arguments); };
}

}  // namespace cls::cli
