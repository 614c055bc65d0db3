// Reads all decisions and writes some of them again.
#include "viewer/decisions/decision_cycles.h"

#include <algorithm>

#include "viewer/decisions/decision_reader.h"
#include "viewer/decisions/decision_writer.h"

namespace cls::viewer {
namespace {

bool in_one_of(const std::vector<CycleRange>& ranges, int cycle) {
  return std::any_of(ranges.begin(), ranges.end(), [cycle](const CycleRange& range) {
    return range.first <= cycle && cycle <= range.last;
  });
}

}  // namespace

base::Result<std::string> select_cycles(std::string_view stream,
                                        const std::vector<CycleRange>& ranges) {
  if (ranges.empty()) return std::string(stream);
  TRY_INIT(auto decisions, read_decisions(stream));

  std::string selected;
  DecisionWriter writer;
  writer.append_header(decisions.side, decisions.team, selected);
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    for (const DecisionSample& sample : decisions.players[static_cast<std::size_t>(unum - 1)]) {
      if (in_one_of(ranges, sample.cycle)) writer.append(unum, sample, selected);
    }
  }

  writer.append_end(selected);
  return selected;
}

}  // namespace cls::viewer
