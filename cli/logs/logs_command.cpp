// `cls logs DIR`: the files of a match and the last output of the process that failed.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "base/text/printable.h"
#include "base/text/suggestion.h"
#include "base/text/table.h"
#include "cli/logs/find_match_folder.h"
#include "cli/logs/prune_matches.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "match/result/match_folder.h"
#include "match/result/match_result.h"
#include "viewer/decisions/decision_files.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
namespace match = match;
using base::Json;

constexpr const char* kLogsDescription =
    "list the files of a match and print the last output of the process that failed\n"
    "\n"
    "  cls logs                        of the latest match in runs/ that failed\n"
    "  cls logs cup --match 17         of match 17 of the tournament in cup\n"
    "  cls logs runs/MATCH --process \"left Playmaker\" --tail 100\n"
    "  cls logs runs --prune 20        deletes all matches of runs/ but the newest 20\n"
    "\n"
    "DIR is a match folder, the folder of a tournament, or a folder of match folders.";

struct LogsArguments {
  std::string folder = "runs";
  std::optional<int> match;
  std::string process;
  std::size_t tail = 20;
  std::optional<std::uint64_t> prune;
  bool dry_run = false;
  bool json = false;
};

struct LogFile {
  std::string name;
  std::uintmax_t bytes = 0;
  std::string what;
  std::string process;  ///< whose output it holds; empty: none
};

struct Tail {
  LogFile file;
  std::vector<std::string> lines;
};

std::string what_is(const std::string& name) {
  const auto is = [&name](const char* known) { return name == known; };

  if (is(match::kResultFile)) return "result (cls.match/1)";
  if (is(match::kManifestFile)) return "command, settings, versions, host";
  if (is(match::kEventsFile)) return "goals and play modes";
  if (is(viewer::kLeftDebugFile)) return "texts and drawings of the left Playmaker";
  if (is(viewer::kRightDebugFile)) return "texts and drawings of the right Playmaker";
  if (is(match::kLeftErrorFile)) return "first failed RPC of the left side";
  if (is(match::kRightErrorFile)) return "first failed RPC of the right side";

  if (name.starts_with(match::kGameLogFile)) return "game log";
  if (name.starts_with(match::kTextLogFile)) return "text log";
  return name.ends_with(".log") ? "output" : "";
}

std::vector<LogFile> files_in(const fs::path& folder, const match::MatchResult& result) {
  std::vector<LogFile> files;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    std::error_code ignored;
    if (!entry.is_regular_file(ignored)) continue;

    const std::string name = entry.path().filename().string();
    LogFile file{name, entry.file_size(ignored), what_is(name), ""};
    for (const match::ProcessResult& process : result.processes) {
      if (process.log != name) continue;
      file.process = process.name;
      file.what = fmt::format("output of {} ({})", process.name, process.exit);
    }

    files.push_back(std::move(file));
  }

  std::ranges::sort(files, {}, &LogFile::name);
  return files;
}

std::vector<std::string> last_lines(const std::string& text, std::size_t count) {
  std::vector<std::string> lines;
  std::size_t end = text.ends_with('\n') ? text.size() - 1 : text.size();
  while (lines.size() < count && end > 0) {
    const std::size_t feed = text.rfind('\n', end - 1);
    const std::size_t begin = feed == std::string::npos ? 0 : feed + 1;
    lines.push_back(base::printable(text.substr(begin, end - begin)));
    if (feed == std::string::npos) break;
    end = feed;
  }

  std::ranges::reverse(lines);
  return lines;
}

// The log of --process, or of the process that failed; nothing if there is none.
base::Result<std::optional<LogFile>> select_log(const std::vector<LogFile>& files,
                                                const match::MatchResult& result,
                                                const std::string& wanted) {
  std::vector<std::string_view> names;
  for (const LogFile& file : files) {
    const bool failed = result.failure && file.name == result.failure->log;
    if (wanted.empty() ? failed : file.process == wanted || file.name == wanted) return {file};
    if (!file.process.empty()) names.push_back(file.process);
  }

  if (wanted.empty()) return std::optional<LogFile>();
  return base::Error{fmt::format("--process '{}': {}", wanted,
                                 names.empty()
                                     ? std::string("the match started no process")
                                     : "no such process" + base::did_you_mean(wanted, names) +
                                           fmt::format(" ({})", fmt::join(names, ", ")))};
}

std::string size_text(std::uintmax_t bytes) {
  if (bytes < 10'000) return fmt::format("{} B", bytes);
  if (bytes < 10'000'000) return fmt::format("{} kB", bytes / 1000);
  return fmt::format("{} MB", bytes / 1'000'000);
}

void print_match_text(const FoundMatch& found, const match::MatchResult& result,
                      const std::vector<LogFile>& files, const std::optional<Tail>& tail) {
  fmt::print("{}{}\n", base::printable(found.folder.string()),
             found.why.empty() ? "" : "  (" + found.why + ")");
  const bool adds_nothing = result.message.empty() || result.message == name(result.end_reason);
  fmt::print("{}{}\n\n", name(result.end_reason),
             adds_nothing ? "" : ": " + base::printable(result.message));

  base::Table table;
  table.add_column("file");
  table.add_column("size", base::Table::Align::kRight);
  table.add_column("contents");
  for (const LogFile& file : files) table.add_row({file.name, size_text(file.bytes), file.what});
  table.allow_folds(2);
  fmt::print("{}", table.format_text({0, static_cast<std::size_t>(stdout_width()), 1}));

  if (!tail) return;
  fmt::print("\nlast {} lines of {}:\n", tail->lines.size(), base::printable(tail->file.name));
  for (const std::string& line : tail->lines) fmt::print("  {}\n", line);
}

void print_match_json(const FoundMatch& found, const match::MatchResult& result,
                      const std::vector<LogFile>& files, const std::optional<Tail>& tail) {
  Json list = Json::array();
  const auto text = [](const std::string& value) {
    return value.empty() ? Json(nullptr) : Json(value);
  };

  for (const LogFile& file : files) {
    list.push_back({{"name", file.name},
                    {"bytes", file.bytes},
                    {"contents", text(file.what)},
                    {"process", text(file.process)}});
  }

  Json document = {{"schema", "cls.logs/1"},
                   {"folder", found.folder.string()},
                   {"end_reason", name(result.end_reason)},
                   {"message", text(result.message)},
                   {"files", std::move(list)},
                   {"tail", nullptr}};

  if (tail) {
    document["tail"] = {
        {"file", tail->file.name}, {"process", text(tail->file.process)}, {"lines", tail->lines}};
  }

  print_json(document);
}

// A match without a result was killed, or is running. The error: a result that cannot be read.
base::Result<match::MatchResult> result_of(const fs::path& folder) {
  const fs::path file = folder / match::kResultFile;
  if (const auto text = base::read_file(file)) {
    auto result = match::parse_match_result(*text);
    if (result) return result;
    return base::Error{fmt::format("{}: {}", file.string(), result.error().message)};
  }

  match::MatchResult unknown;
  unknown.end_reason = match::EndReason::kInterrupted;
  unknown.message = "no result.json: cls was killed, or the match is running";
  return unknown;
}

int prune(const LogsArguments& arguments) {
  TRY_INIT_OR(kNoInput, const auto old, find_old_matches(arguments.folder, *arguments.prune));
  if (!arguments.dry_run) {
    TRY_OR(kWriteFailed, delete_matches(old));
  }

  if (arguments.json) {
    Json folders = Json::array();
    for (const fs::path& folder : old.folders) folders.push_back(folder.string());
    return print_json({{"schema", "cls.prune/1"},
                       {"deleted", !arguments.dry_run},
                       {"folders", std::move(folders)},
                       {"bytes", old.bytes},
                       {"left", old.left}});
  }

  if (arguments.dry_run) {
    for (const fs::path& folder : old.folders) {
      fmt::print("{}\n", base::printable(folder.string()));
    }
  }

  fmt::print("{} {}, {}; {} left\n", arguments.dry_run ? "would delete" : "deleted",
             base::counted(old.folders.size(), "match", "matches"), size_text(old.bytes), old.left);
  return kOk;
}

int run_logs_command(const LogsArguments& arguments) {
  if (arguments.prune) return prune(arguments);
  if (arguments.dry_run) return print_error(kUsage, "--dry-run needs --prune N");

  TRY_INIT_OR(kNoInput, const auto found, find_match_folder(arguments.folder, arguments.match));

  TRY_INIT_OR(kBadData, const auto result, result_of(found.folder));

  const std::vector<LogFile> files = files_in(found.folder, result);
  TRY_INIT_OR(kUsage, const auto log, select_log(files, result, arguments.process));

  std::optional<Tail> tail;
  if (log) {
    const auto text = base::read_file(found.folder / log->name);
    tail = Tail{*log, last_lines(text.value_or(""), arguments.tail)};
  }

  (arguments.json ? print_match_json : print_match_text)(found, result, files, tail);
  return kOk;
}

}  // namespace

void add_logs_command(Command& app) {
  auto [command, arguments] = app.command("logs", kLogsDescription, run_logs_command);
  command.group = kResultCommands;

  command.setting("DIR", arguments.folder, "folder of a match, a tournament or matches");
  command.option("--match", arguments.match, "number of a match in the tournament")
      .placeholder("K");
  command
      .option("--process", arguments.process,
              "print the output of this process or log file (default: the one that failed)")
      .placeholder("NAME");

  command.setting("--tail", arguments.tail, "lines to print");
  command
      .option("--prune", arguments.prune,
              "delete the matches of DIR but the newest N; not tournaments, not what is played now")
      .placeholder("N");
  command.flag("--dry-run", arguments.dry_run, "with --prune: only list them")
      .of_group(kDebuggingGroup);
  command.flag("--json", arguments.json, "print a JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
