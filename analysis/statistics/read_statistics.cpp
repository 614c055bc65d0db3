// Reads matches in parallel. Each match is formatted immediately, so that its record is freed.
#include "analysis/statistics/read_statistics.h"

#include <utility>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "analysis/statistics/spadl_actions.h"
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

// A CSV table: its columns, and how the rows of a match are added.
struct CsvFormat {
  base::Table (*columns)();
  void (*add)(const MatchSummary&, const MatchStatistics&, base::Table&);
};

CsvFormat csv_format(StatisticsFormat format) {
  switch (format) {
    case StatisticsFormat::kCsvPlayers:
      return {player_table, add_players};
    case StatisticsFormat::kCsvEvents:
      return {event_table, add_events};
    case StatisticsFormat::kSpadl:
      return {spadl_table, add_spadl};
    default:
      return {team_table, add_teams};
  }
}

void write_part(const MatchSummary& summary, const MatchStatistics& statistics,
                StatisticsFormat format, bool events, std::size_t width, Part& part) {
  if (format == StatisticsFormat::kText) {
    part.text = statistics_text(summary, statistics, width);
  } else if (format == StatisticsFormat::kJson) {
    part.text = statistics_json(summary, statistics, events);
  } else {
    csv_format(format).add(summary, statistics, part.rows);
  }
}

std::optional<gamelog::RclRecord> read_text(const std::string& file,
                                            std::vector<LogProblem>& problems) {
  if (file.empty()) return std::nullopt;

  auto text = gamelog::read_rcl_file(file);
  if (!text) {
    problems.push_back({file, text.error().message, {}});
    return std::nullopt;
  }
  if (!text->errors.empty()) problems.push_back({file, "", text->errors});
  return *std::move(text);
}

Part read_part(const MatchInput& input, StatisticsFormat format, bool events, std::size_t width) {
  const gamelog::MatchLogs& logs = input.logs;
  Part part;
  part.rows = csv_format(format).columns();
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

  const auto text = read_text(logs.text, part.problems);
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

  base::Table table = csv_format(format).columns();
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
