// Reads logs and computes.
#include "cli/logs/analyzed_match.h"

#include <fmt/format.h>

#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "gamelog/rcg/rcg_writer.h"
#include "match/result/recorded_end.h"

namespace cls::cli {

int read_match(const std::string& what, AnalyzedMatch& match) {
  TRY_INIT_OR(kNoInput, auto found, find_log(what));
  match.found = std::move(found);

  const std::string& log = match.found.logs.game;
  TRY_INIT_OR(unreadable_code(log), auto read, viewer::read_log_or_page(log));
  report_errors(log, read.record.errors);

  if (read.record.frames() == 0) {
    return print_error(kBadData, "{}: no frame", log);
  }
  match.match = std::move(read);

  match.text = read_text_log(match.found);
  match.statistics = analysis::compute_statistics(match.match.record, match.text_log());
  match.summary = analysis::summarize(match.match.record, match.text_log());
  match.summary.file = std::filesystem::path(log).filename().string();

  namespace recorded = match;
  if (const auto end = recorded::recorded_end(log)) analysis::set_end(*end, match.summary);

  // Logs of cls have a constant date, so that equal matches have equal logs.
  std::string& date = match.summary.date;
  if (date.empty() || date == gamelog::LogDate().minute) date = recorded::recorded_date(log);

  return kOk;
}

}  // namespace cls::cli
