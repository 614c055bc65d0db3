// Reads matches in parallel. Each match is formatted immediately, so that its record is freed.
#include "analysis/statistics/read_statistics.h"

#include <utility>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "analysis/statistics/spadl_table.h"
#include "analysis/statistics/statistics_json.h"
#include "analysis/statistics/statistics_text.h"
#include "base/system/parallel.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"

namespace cls::analysis {
namespace {

struct Part {
  std::string text;
  base::Table rows;
  std::vector<LogProblem> problems;
  bool usable = false;
};

base::Table empty_table(StatisticsFormat format) {
  return format == StatisticsFormat::kCsvPlayers  ? player_table()
         : format == StatisticsFormat::kCsvEvents ? event_table()
         : format == StatisticsFormat::kSpadl     ? spadl_table()
                                                  : team_table();
}

void write_part(const MatchSummary& summary, const MatchStatistics& statistics,
                StatisticsFormat format, bool events, std::size_t width, Part& part) {
  switch (format) {
    case StatisticsFormat::kText:
      part.text = statistics_text(summary, statistics, width);
      break;
    case StatisticsFormat::kJson:
      part.text = statistics_json(summary, statistics, events);
      break;
    case StatisticsFormat::kCsv:
      add_teams(summary, statistics, part.rows);
      break;
    case StatisticsFormat::kCsvPlayers:
      add_players(summary, statistics, part.rows);
      break;
    case StatisticsFormat::kCsvEvents:
      add_events(summary, statistics, part.rows);
      break;
    case StatisticsFormat::kSpadl:
      add_spadl(summary, statistics, part.rows);
      break;
  }
}

Part read_part(const MatchInput& input, StatisticsFormat format, bool events, std::size_t width) {
  const gamelog::MatchLogs& logs = input.logs;
  Part part;
  part.rows = empty_table(format);
  if (logs.game.empty()) {
    part.problems.push_back({logs.text, logs.text + ": no game log (rcg) beside it", {}});
    return part;
  }
  const auto record = gamelog::read_rcg_file(logs.game);
  if (!record) {
    part.problems.push_back({logs.game, record.error().message, {}});
    return part;
  }
  if (!record->errors.empty()) part.problems.push_back({logs.game, "", record->errors});
  if (record->frames() == 0) return part;
  std::optional<gamelog::RclRecord> text;
  if (!logs.text.empty()) {
    auto read = gamelog::read_rcl_file(logs.text);
    if (!read) {
      part.problems.push_back({logs.text, read.error().message, {}});
    } else {
      text = std::move(*read);
      if (!text->errors.empty()) part.problems.push_back({logs.text, "", text->errors});
    }
  }
  const gamelog::RclRecord* text_log = text ? &*text : nullptr;
  MatchSummary summary = summarize(*record, text_log);
  summary.file = logs.game;
  summary.text_log = text ? logs.text : "";
  if (input.end) set_end(*input.end, summary);
  part.usable = true;
  write_part(summary, compute_statistics(*record, text_log), format, events, width, part);
  return part;
}

std::string joined(std::vector<Part>& parts, StatisticsFormat format) {
  if (format == StatisticsFormat::kJson) {
    std::vector<std::string> matches;
    for (Part& part : parts) {
      if (part.usable) matches.push_back(std::move(part.text));
    }
    return statistics_document(matches);
  }
  std::string text;
  if (format == StatisticsFormat::kText) {
    for (const Part& part : parts) {
      if (!text.empty() && part.usable) text += "\n\n";
      text += part.text;
    }
    return text;
  }
  base::Table table = empty_table(format);
  for (Part& part : parts) table.append_rows(std::move(part.rows));
  return table.format_csv();
}

}  // namespace

StatisticsOutput read_statistics(const std::vector<MatchInput>& matches, StatisticsFormat format,
                                 bool events, std::size_t jobs,
                                 const std::function<void(std::size_t)>& on_done,
                                 std::size_t width) {
  std::vector<Part> parts(matches.size());
  const auto work = [&](std::size_t i) { parts[i] = read_part(matches[i], format, events, width); };
  base::parallel_for(matches.size(), jobs, work, on_done);
  StatisticsOutput output;
  for (Part& part : parts) {
    for (LogProblem& problem : part.problems) output.problems.push_back(std::move(problem));
  }
  output.text = joined(parts, format);
  return output;
}

}  // namespace cls::analysis
