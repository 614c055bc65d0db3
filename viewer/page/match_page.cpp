// Computes the statistics and decisions of a page.
#include "viewer/page/match_page.h"

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "analysis/statistics/statistics_json.h"
#include "base/io/byte_source.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"
#include "viewer/stream/chunk_writer.h"

namespace cls::viewer {
namespace {

analysis::MatchSummary summary_of(const gamelog::MatchRecord& record,
                                  const gamelog::RclRecord* text, const std::string& file) {
  analysis::MatchSummary summary = analysis::summarize(record, text);
  summary.file = file;
  return summary;
}

std::string statistics_of(const analysis::MatchSummary& summary, const gamelog::MatchRecord& record,
                          const gamelog::RclRecord* text) {
  return analysis::statistics_json(summary, analysis::compute_statistics(record, text), true);
}

}  // namespace

std::string match_page(const gamelog::MatchRecord& record, const gamelog::RclRecord* text,
                       const std::string& file, const MatchPageOptions& options) {
  const analysis::MatchSummary summary = summary_of(record, text, file);
  const std::string stream =
      write_stream(record, {.compact = options.compact}, statistics_of(summary, record, text));
  return write_page(summary, stream, options.settings, options.decisions);
}

std::string match_statistics(const gamelog::MatchRecord& record, const gamelog::RclRecord* text,
                             const std::string& file) {
  return statistics_of(summary_of(record, text, file), record, text);
}

std::string page_of_logs(const std::string& game_log, const std::string& text_log,
                         const std::string& file) {
  base::MemorySource game(game_log);
  const gamelog::MatchRecord record = gamelog::read_rcg(game);
  if (record.frames() == 0) return {};

  base::MemorySource commands(text_log);
  const gamelog::RclRecord text = gamelog::read_rcl(commands);
  return match_page(record, &text, file);
}

}  // namespace cls::viewer
