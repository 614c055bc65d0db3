// Computes what a page contains besides the log.
#include "viewer/page/match_page.h"

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "analysis/statistics/statistics_json.h"
#include "viewer/stream/chunk_writer.h"

namespace cls::viewer {

std::string match_page(const gamelog::MatchRecord& record, const gamelog::RclRecord* text,
                       const std::string& file, bool compact, const PageSettings& settings) {
  analysis::MatchSummary summary = analysis::summarize(record, text);
  summary.file = file;
  const std::string statistics =
      analysis::statistics_json(summary, analysis::compute_statistics(record, text), true);
  StreamForm form;
  form.compact = compact;
  return write_page(summary, write_stream(record, form, statistics), settings);
}

}  // namespace cls::viewer
