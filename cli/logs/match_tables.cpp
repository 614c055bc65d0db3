// Streams the tracking table of one log; keeps the record of a match for all other tables.
#include "cli/logs/match_tables.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "analysis/play/flow.h"
#include "analysis/tables/cdf_match.h"
#include "analysis/tables/log_tables.h"
#include "base/io/whole_file.h"
#include "base/system/parallel.h"
#include "base/text/enum_names.h"
#include "cli/logs/find_log.h"
#include "cli/logs/output_file.h"
#include "cli/support/interrupt.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "cli/terminal/log_progress.h"
#include "gamelog/files/log_files.h"
#include "gamelog/rcg/frame_stream.h"
#include "tournament/dataset/dataset.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/decisions/decision_table.h"
#include "viewer/page/page.h"
#include "viewer/page/page_decisions.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
namespace tournament = tournament;
using gamelog::MatchRecord;

constexpr const char* kMatchStem = "match";  // of the logs of `cls match`

constexpr auto kTableNames = base::enum_names<MatchTable>("tracking", "player_types", "event");

void write_frames(const MatchRecord& record, analysis::TrackingTable& rows) {
  for (std::size_t i = 0; i < record.frames(); ++i) rows.on_frame(record, i);
}

void write_table(MatchTable table, const MatchRecord& record, analysis::TrackingColumns columns,
                 base::ByteSink& sink) {
  switch (table) {
    case MatchTable::kTracking: {
      analysis::TrackingTable rows(sink, columns);
      return write_frames(record, rows);
    }
    case MatchTable::kPlayerTypes:
      return sink.write(analysis::player_type_table(record));
    case MatchTable::kEvents:
      return sink.write(analysis::event_table(analysis::build_flow(record)));
  }
}

// The one log that `in` stands for.
base::Result<std::string> one_log(const std::string& in) {
  std::error_code code;
  if (!fs::is_directory(in, code)) return in;

  std::vector<std::string> logs;
  for (const gamelog::MatchLogs& match : gamelog::find_logs({in}).matches) {
    if (!match.game.empty()) logs.push_back(match.game);
  }

  if (logs.size() == 1) return logs.front();
  if (logs.empty()) return base::Error{fmt::format("{}: no game log in this folder", in)};
  return base::Error{
      fmt::format("{}: has {} game logs; write their tables with --tables DIR", in, logs.size())};
}

int finish(const std::string& in, const gamelog::ParseErrors& errors,
           const std::optional<OutputFailure>& failure, TableCounts& counts) {
  counts.errors = errors.count;
  report_errors(in, errors);

  TRY_STEP(report_failure(failure));
  return errors.empty() ? kOk : kBadData;
}

int stream_tracking(base::ByteSource& source, const std::string& in, const TableRequest& request,
                    TableCounts& counts) {
  gamelog::ParseErrors errors;
  std::string page_error;

  const auto failure = write_output(request.out, [&](base::ByteSink& sink) {
    analysis::TrackingTable table(sink, request.columns);
    gamelog::FrameStream stream(source, table);
    if (viewer::looks_like_page_or_stream(stream.input().peek(viewer::kMatchStart))) {
      const auto match = viewer::read_page_or_stream(stream.input());
      if (!match) page_error = fmt::format("{}: {}", in, match.error().message);
      if (match) write_frames(match->record, table);
      if (match) counts.frames = match->record.frames();
      return match.ok();
    }
    errors = stream.read_all().errors;
    counts.frames = stream.frames();
    return counts.frames > 0 || errors.empty();
  });

  if (!page_error.empty()) return print_error(kBadData, page_error);
  return finish(in, errors, failure, counts);
}

int write_from_record(MatchTable table, const std::string& in, const TableRequest& request,
                      TableCounts& counts) {
  TRY_INIT_OR(unreadable_code(in), const auto match, viewer::read_log_or_page(in));
  const MatchRecord& record = match.record;
  counts.frames = record.frames();

  const auto failure = write_output(request.out, [&](base::ByteSink& sink) {
    write_table(table, record, request.columns, sink);
    return record.frames() > 0 || record.errors.empty();
  });

  return finish(in, record.errors, failure, counts);
}

// One of many matches, while its files are written.
struct OneMatch {
  const MatchRecord& record;
  std::string id;
  analysis::TrackingColumns columns;
  std::unique_ptr<analysis::CdfMatch> cdf;
  std::optional<gamelog::RclRecord> text;
  std::vector<viewer::TeamDecisions> decisions;
};

struct FileKind {
  const char* suffix;
  void (*write)(const OneMatch& match, base::ByteSink& sink);
  bool (*has)(const OneMatch& match) = [](const OneMatch&) { return true; };
};

template <MatchTable kTable>
void write_table_of(const OneMatch& match, base::ByteSink& sink) {
  write_table(kTable, match.record, match.columns, sink);
}

constexpr FileKind kTableFiles[] = {
    {".tracking.csv", write_table_of<MatchTable::kTracking>},
    {".player_types.csv", write_table_of<MatchTable::kPlayerTypes>},
    {".event.csv", write_table_of<MatchTable::kEvents>},
};

constexpr FileKind kCdfFiles[] = {
    {".match.json",
     [](const OneMatch& match, base::ByteSink& sink) {
       sink.write(analysis::cdf_match_document(*match.cdf));
     }},
    {".meta.json",
     [](const OneMatch& match, base::ByteSink& sink) {
       sink.write(analysis::cdf_meta_document(*match.cdf));
     }},
    {".event.jsonl", [](const OneMatch& match,
                        base::ByteSink& sink) { sink.write(analysis::cdf_events(*match.cdf)); }},
    {".tracking.jsonl",
     [](const OneMatch& match, base::ByteSink& sink) {
       analysis::write_cdf_tracking(*match.cdf, sink);
     }},
};

constexpr FileKind kArrowFiles[] = {
    {".frames.arrow",
     [](const OneMatch& match, base::ByteSink& sink) {
       analysis::write_frames_arrow(match.record, sink);
     }},
    {".events.arrow",
     [](const OneMatch& match, base::ByteSink& sink) {
       analysis::write_events_arrow(analysis::build_flow(match.record), sink);
     }},
    {".player_types.csv", write_table_of<MatchTable::kPlayerTypes>},
    {".commands.arrow",
     [](const OneMatch& match, base::ByteSink& sink) {
       analysis::write_commands_arrow(*match.text, sink);
     },
     [](const OneMatch& match) { return match.text.has_value(); }},
    {".world_models.arrow",
     [](const OneMatch& match, base::ByteSink& sink) {
       viewer::write_decisions_arrow(match.decisions, sink);
     },
     [](const OneMatch& match) { return !match.decisions.empty(); }},
};

std::span<const FileKind> kinds_of(MatchFiles files) {
  if (files == MatchFiles::kArrow) return kArrowFiles;
  if (files == MatchFiles::kCdf) return kCdfFiles;
  return kTableFiles;
}

// A log of many, and where its files go.
struct Job {
  std::string log;
  std::string text;  ///< its text log; empty: none
  std::string id;    ///< the name of the log, without endings
  fs::path stem;     ///< of its files, without suffix
  std::optional<OutputFailure> failure{};
  gamelog::ParseErrors errors{};
  std::string unreadable{};
  std::size_t frames = 0;
};

fs::path without_endings(const fs::path& file) {
  fs::path name(gamelog::unpacked_name(file.native()));
  for (const char* ending : {".rcg", ".json", ".html", ".view"}) {
    if (name.extension() == ending) name.replace_extension();
  }
  return name;
}

// The logs of a folder, or the matches of a data set; `problems` gets a line for each match of a
// data set that cannot be read.
base::Result<gamelog::FoundLogs> logs_of(const std::string& in,
                                         std::vector<std::string>& problems) {
  if (!tournament::is_dataset(in)) return gamelog::find_logs({in});
  TRY_INIT(const auto matches, tournament::read_dataset_matches(in));
  gamelog::FoundLogs found;
  for (const tournament::DatasetMatch& match : matches) {
    if (match.files.empty()) continue;
    const auto log = tournament::find_dataset_file(in, match.files.front());
    if (log) {
      found.matches.push_back({log->string(), ""});
    } else {
      problems.push_back(fmt::format("{}: {}", in, log.error().message));
    }
  }
  return found;
}

// Logs keep the folders that they have below `in`.
std::vector<Job> plan_jobs(const gamelog::FoundLogs& found, const TableRequest& request) {
  std::error_code code;
  const bool below = fs::is_directory(request.in, code);
  std::vector<Job> jobs;
  for (const gamelog::MatchLogs& match : found.matches) {
    if (match.game.empty()) continue;
    const fs::path log = match.game == "-" ? fs::path("match") : fs::path(match.game);
    const fs::path name =
        without_endings(below ? log.lexically_relative(request.in) : log.filename());
    jobs.push_back({match.game, match.text, name.generic_string(), fs::path(request.out) / name});
  }

  return jobs;
}

fs::path file_of(const Job& job, const FileKind& kind) { return job.stem.string() + kind.suffix; }

// Two logs of a pattern can have the same name in different folders.
std::optional<OutputFailure> check_outputs(const std::vector<Job>& jobs,
                                           std::span<const FileKind> kinds, bool force) {
  std::map<fs::path, const std::string*> logs;  // by the stem of their files
  for (const Job& job : jobs) {
    const auto [known, is_new] = logs.emplace(job.stem, &job.log);
    if (!is_new) {
      return OutputFailure{kUsage, fmt::format("{} and {} would have the same files; name their "
                                               "folder, whose sub-folders they keep",
                                               *known->second, job.log)};
    }
    for (const FileKind& kind : kinds) {
      if (auto failure = why_not_replaced(file_of(job, kind), force)) return failure;
    }
  }
  return std::nullopt;
}

// The world models of a match folder or a data set; none without them.
base::Result<std::vector<viewer::TeamDecisions>> read_world_models(const Job& job) {
  const fs::path log = without_endings(job.log);
  std::vector<viewer::TeamDecisions> teams;
  for (const char* file : {viewer::kLeftWorldModelsFile, viewer::kRightWorldModelsFile}) {
    std::error_code code;
    fs::path path = log.string() + "." + file;
    const bool of_match = log.filename() == kMatchStem && !fs::exists(path, code);
    if (of_match) path = log.parent_path() / file;
    if (!fs::exists(path, code)) continue;
    TRY_INIT(auto team, viewer::read_recorded_decisions(path));
    teams.push_back(std::move(team));
  }

  return teams;
}

// Reads what Arrow files have beyond the game log.
void read_more(Job& job, OneMatch& match) {
  match.text = read_text_log({{job.log, job.text}, "", ""});
  auto decisions = read_world_models(job);
  if (decisions) {
    match.decisions = *std::move(decisions);
  } else {
    job.failure = {kBadData, decisions.error().message};
  }
}

void run_job(Job& job, MatchFiles files, analysis::TrackingColumns columns) {
  const auto match = viewer::read_log_or_page(job.log);
  if (!match) {
    job.unreadable = match.error().message;
    return;
  }

  const MatchRecord& record = match->record;
  job.errors = record.errors;
  job.frames = record.frames();

  if (record.frames() == 0 && !record.errors.empty()) return;
  if (const auto created = base::create_folders(job.stem.parent_path()); !created) {
    job.failure = {kCannotCreate, created.error().message};
    return;
  }
  OneMatch one{record, job.id, columns, nullptr, std::nullopt, {}};
  if (files == MatchFiles::kCdf) one.cdf = std::make_unique<analysis::CdfMatch>(record, job.id);
  if (files == MatchFiles::kArrow) read_more(job, one);
  for (const FileKind& kind : kinds_of(files)) {
    if (job.failure) return;
    if (!kind.has(one)) continue;
    job.failure = write_output(file_of(job, kind), [&](base::ByteSink& sink) {
      kind.write(one, sink);
      return true;
    });
  }
}

}  // namespace

std::string_view name(MatchTable table) { return kTableNames.name(table); }

std::optional<MatchTable> parse_match_table(std::string_view text) {
  return kTableNames.parse(text);
}

std::optional<MatchTable> table_of_file(std::string_view path) {
  if (path.ends_with(".gz")) path.remove_suffix(3);
  if (!path.ends_with(".csv")) return std::nullopt;

  path.remove_suffix(4);
  const std::size_t dot = path.rfind('.');
  return dot == path.npos ? std::nullopt : kTableNames.parse(path.substr(dot + 1));
}

int write_match_table(MatchTable table, const TableRequest& request, TableCounts& counts) {
  TRY_STEP(report_failure(why_not_replaced(request.out, request.force)));
  TRY_INIT_OR(kNoInput, const auto log, one_log(request.in));
  counts.matches = 1;
  if (table != MatchTable::kTracking) return write_from_record(table, log, request, counts);

  TRY_INIT_OR(unreadable_code(log), auto source, base::open_source(log));
  return stream_tracking(*source, log, request, counts);
}

int write_match_files(MatchFiles files, const TableRequest& request, TableCounts& counts) {
  std::vector<std::string> problems;
  TRY_INIT_OR(kBadData, const auto found, logs_of(request.in, problems));
  std::vector<Job> jobs = plan_jobs(found, request);
  int exit_code = report_missing(found);
  for (const std::string& problem : problems) exit_code = print_error(kBadData, problem);
  if (exit_code == kOk && jobs.empty()) {
    return print_error(kNoInput, "{}: no game log (rcg)", request.in);
  }
  if (const auto failure = check_outputs(jobs, kinds_of(files), request.force)) {
    return report_failure(failure);
  }

  const std::atomic<int>& signal = watch_interrupts();
  LogProgress progress(jobs.size());
  base::parallel_for(
      jobs.size(), request.jobs,
      [&](std::size_t i) {
        if (signal == 0) run_job(jobs[i], files, request.columns);
      },
      [&](std::size_t count) { progress.update(count); });

  counts.matches = jobs.size();
  for (const Job& job : jobs) {
    exit_code = report_log(exit_code, job.unreadable, job.log, job.errors);
    if (job.failure) exit_code = report_failure(job.failure);
    counts.frames += job.frames;
    counts.errors += job.errors.count;
  }

  return signal == 0 ? exit_code : signal_exit_code(signal);
}

}  // namespace cls::cli
