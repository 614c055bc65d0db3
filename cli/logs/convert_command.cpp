// `cls convert IN OUT`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/system/parallel.h"
#include "base/text/json.h"
#include "cli/logs/match_tables.h"
#include "cli/logs/output_file.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "gamelog/rcg/record_writer.h"
#include "viewer/page/page.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

using gamelog::RcgVersion;

constexpr const char* kConvertDescription =
    "convert a game log to another version or into tables\n"
    "Reads rcg versions 1 to 7 and JSON, plain or compressed (gzip, xz, zstd), and\n"
    "pages of 'cls watch'.\n"
    "\n"
    "  cls convert old.rcg.gz new.rcg             version 6\n"
    "  cls convert game.rcg game.rcg.gz --to 4    version 4, compressed\n"
    "  cls convert game.rcg game.json             JSON, by the name\n"
    "  cls convert page.html game.rcg             the log of the page, as it was\n"
    "  cls convert game.rcg game.tracking.csv     a row per frame, by the name\n"
    "  cls convert cup --tables csv               all tables of all matches in cup\n"
    "  cls convert cup --tables out --format arrow  with types and units\n"
    "\n"
    "Tables are OUT.tracking.csv, OUT.player_types.csv and OUT.event.csv. '-' is\n"
    "standard input or output. Of a corrupt log, the readable frames are converted.";

struct ConvertArguments {
  std::string in;
  std::string out;
  std::string to;
  std::string tables;
  std::string cdf;
  std::string format = "csv";
  bool published = false;
  bool json = false;
  bool force = false;
  std::size_t jobs = base::default_jobs();

  bool has_folder() const { return !tables.empty() || !cdf.empty(); }
};

// The table that OUT is; nothing for a log.
std::optional<MatchTable> table_of(const ConvertArguments& arguments) {
  return arguments.to.empty() ? table_of_file(arguments.out) : parse_match_table(arguments.to);
}

// False for a value of --to that no log can be written in.
bool parse_target(const std::string& to, std::optional<RcgVersion>& version) {
  if (to == "4") version = RcgVersion::kV4;
  if (to == "5") version = RcgVersion::kV5;
  if (to == "6") version = RcgVersion::kV6;
  if (to == "7") version = RcgVersion::kV7;
  if (to == "json") version = RcgVersion::kJson;
  return to.empty() || version.has_value();
}

// Without --to the name decides; a page gives the log back in its own version.
RcgVersion default_target(const std::string& out, const viewer::StreamMatch& match) {
  if (out.ends_with(".json") || out.ends_with(".json.gz")) return RcgVersion::kJson;
  return match.from_page ? std::max(match.record.version, RcgVersion::kV4) : RcgVersion::kV6;
}

constexpr std::array<std::string_view, 4> kEndings = {".rcg", ".rcg.gz", ".json", ".json.gz"};

// Without --to a file must say by its ending what it shall be; devices and pipes have none.
bool names_format(const std::string& out) {
  std::error_code code;
  const fs::file_type type = fs::status(out, code).type();
  if (out == "-" || (type != fs::file_type::regular && type != fs::file_type::not_found)) {
    return true;
  }
  return std::ranges::any_of(kEndings,
                             [&out](std::string_view ending) { return out.ends_with(ending); });
}

void print_document(const ConvertArguments& arguments, RcgVersion version,
                    const gamelog::MatchRecord& record) {
  base::Json document = {{"schema", "cls.convert/1"}, {"in", arguments.in},
                         {"out", arguments.out},      {"version", static_cast<int>(version)},
                         {"frames", record.frames()}, {"errors", record.errors.count}};

  if (version == RcgVersion::kJson) document["version"] = "json";
  print_json(document);
}

void print_document(const ConvertArguments& arguments, const TableCounts& counts) {
  base::Json document = {{"schema", "cls.convert/1"}, {"in", arguments.in}};
  if (!arguments.tables.empty()) {
    document["tables"] = arguments.tables;
  } else if (!arguments.cdf.empty()) {
    document["cdf"] = arguments.cdf;
  } else {
    document["out"] = arguments.out;
    document["version"] = name(*table_of(arguments));
  }

  document["matches"] = counts.matches;
  document["frames"] = counts.frames;
  document["errors"] = counts.errors;
  print_json(document);
}

MatchFiles files_of(const ConvertArguments& arguments) {
  if (!arguments.cdf.empty()) return MatchFiles::kCdf;
  return arguments.format == "arrow" ? MatchFiles::kArrow : MatchFiles::kTables;
}

int run_tables(const ConvertArguments& arguments) {
  TableRequest request{.in = arguments.in, .out = arguments.out};
  if (arguments.published) request.columns = analysis::TrackingColumns::kPublished;
  request.force = arguments.force;
  request.jobs = arguments.jobs;

  TableCounts counts;
  int exit_code = kOk;
  if (arguments.has_folder()) {
    const bool cdf = arguments.tables.empty();
    request.out = cdf ? arguments.cdf : arguments.tables;
    exit_code = write_match_files(files_of(arguments), request, counts);
  } else {
    exit_code = write_match_table(*table_of(arguments), request, counts);
  }

  if (arguments.json && (exit_code == kOk || exit_code == kBadData)) {
    print_document(arguments, counts);
  }

  return exit_code;
}

// Why the arguments do not fit together; empty: they do.
std::string why_wrong(const ConvertArguments& arguments) {
  const int outputs = !arguments.out.empty() + !arguments.tables.empty() + !arguments.cdf.empty();
  if (outputs == 0) return "convert: name OUT, or a folder with --tables DIR or --cdf DIR";
  if (outputs > 1) return "convert: only one of OUT, --tables DIR and --cdf DIR";
  if (arguments.has_folder() && !arguments.to.empty()) {
    return "--to: --tables and --cdf write all files; name OUT for one table";
  }

  std::optional<RcgVersion> version;
  if (!table_of(arguments) && !parse_target(arguments.to, version)) {
    return fmt::format("--to '{}': must be 4, 5, 6, 7, json, tracking, player_types or event",
                       arguments.to);
  }
  if (!version && !table_of(arguments) && !arguments.has_folder() && !names_format(arguments.out)) {
    return fmt::format(
        "OUT '{}': its ending names no format; use {}, .tracking.csv, .player_types.csv, "
        ".event.csv or --to",
        arguments.out, fmt::join(kEndings, ", "));
  }
  const bool arrow = arguments.format == "arrow";
  if (arrow && arguments.tables.empty()) return "--format arrow: only with --tables DIR";

  const bool tracks =
      (!arguments.tables.empty() && !arrow) || table_of(arguments) == MatchTable::kTracking;
  if (arguments.published && !tracks) {
    return "--published: only for tracking tables";
  }

  if (arguments.json && arguments.out == "-") {
    return "--json: OUT is stdout already; name a file";
  }

  return "";
}

int write_log(const ConvertArguments& arguments, const viewer::StreamMatch& match,
              RcgVersion version) {
  const auto failure = write_output(arguments.out, [&](base::ByteSink& sink) {
    gamelog::write_rcg(match.record, version, sink);
    return true;
  });

  return report_failure(failure);
}

int run_convert_command(const ConvertArguments& arguments) {
  if (const std::string why = why_wrong(arguments); !why.empty()) return print_error(kUsage, why);
  if (arguments.has_folder() || table_of(arguments)) return run_tables(arguments);
  if (const auto failure = why_not_replaced(arguments.out, arguments.force)) {
    return print_error(failure->exit_code, failure->message);
  }

  TRY_INIT_OR(unreadable_code(arguments.in), const auto match,
              viewer::read_log_or_page(arguments.in));
  if (match.form.compact) {
    return print_error(kBadData,
                       "{}: a compact page, which is not a log; write it "
                       "without --compact",
                       arguments.in);
  }

  const gamelog::MatchRecord& record = match.record;
  std::optional<RcgVersion> target;
  parse_target(arguments.to, target);
  const RcgVersion version = target ? *target : default_target(arguments.out, match);

  report_errors(arguments.in, record.errors);
  if (record.frames() == 0 && !record.errors.empty()) return kBadData;

  TRY_STEP(write_log(arguments, match, version));
  if (arguments.json) print_document(arguments, version, record);
  return record.errors.empty() ? kOk : kBadData;
}

}  // namespace

void add_convert_command(Command& app) {
  auto [command, arguments] = app.command("convert", kConvertDescription, run_convert_command);
  command.group = kResultCommands;

  command.option("IN", arguments.in, "input game log; for tables also a folder or data set")
      .required();
  command.option("OUT", arguments.out, "output file, compressed if it ends in .gz");
  command.option("--to VERSION", arguments.to,
                 "version: 4, 5, 6, 7 or json (default: 6, json for OUT.json, that of\n"
                 "the log for a page); or a table: tracking, player_types or event");

  command.option("--tables DIR", arguments.tables,
                 "write all tables of each match into this folder");
  command
      .setting("--format FORMAT", arguments.format, "of these tables; arrow has world models, too")
      .of_group(kOutputGroup)
      .one_of({"csv", "arrow"});
  command.option("--cdf DIR", arguments.cdf,
                 "write each match in the Common Data Format into this folder");
  command.flag("--published", arguments.published,
               "tracking tables of 168 columns, as published for 2021 and 2024");
  command.flag("--force", arguments.force, "replace existing files");
  command
      .option("--jobs", arguments.jobs,
              "with --tables and --cdf: logs read in parallel (default: one per core)")
      .above(0);

  command.flag("--json", arguments.json, "print frames and errors as one JSON document")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
