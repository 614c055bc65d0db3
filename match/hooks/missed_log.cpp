// Collects misses by side and writes them in the order of the match.
#include "match/hooks/missed_log.h"

#include <algorithm>
#include <tuple>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/json_text.h"

namespace cls::match {

void MissedOfSide::on_decision(const proxy::Decision& decision) {
  if (decision.status.ok()) return;
  const player::GameTime time = decision.agent.world().game.time;
  missed_.push_back(
      {time.cycle, time.stopped, side_, decision.agent.unum(), decision.status.outcome});
}

std::string MissedLog::close() {
  std::vector<Missed> all = sides_.left.missed();
  all.insert(all.end(), sides_.right.missed().begin(), sides_.right.missed().end());
  if (all.empty()) return {};

  const auto order = [](const Missed& one) {
    return std::tuple(one.cycle, one.stopped, one.side == soccer::Side::kRight, one.unum);
  };
  std::ranges::stable_sort(all, {}, order);

  std::string lines;
  for (const Missed& one : all) {
    const base::Json line = {{"t", one.cycle},
                             {"stopped", one.stopped},
                             {"side", soccer::side_name(one.side)},
                             {"unum", one.unum},
                             {"reason", name(one.reason)}};
    lines += base::json_line(line) + "\n";
  }

  const auto written = base::write_file(file_, lines);
  return written ? std::string() : written.error().message;
}

}  // namespace cls::match
