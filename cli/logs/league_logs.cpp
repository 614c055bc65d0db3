// Converts game logs; text logs stay as they are.
#include "cli/logs/league_logs.h"

#include <fmt/format.h>

#include <array>

#include "base/io/byte_source.h"
#include "cli/logs/find_log.h"
#include "gamelog/rcg/rcg_writer.h"
#include "gamelog/rcg/record_writer.h"
#include "viewer/page/page.h"

namespace cls::cli {
namespace {

std::string start_text(std::time_t start) {
  std::tm parts{};
  ::localtime_r(&start, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y%m%d%H%M%S-", &parts)};
}

}  // namespace

base::Result<LeagueLogs> read_league_logs(const std::filesystem::path& folder, std::time_t start) {
  TRY_INIT(const auto found, find_log(folder.string()));
  TRY_INIT(const auto match, viewer::read_log_or_page(found.logs.game));
  const gamelog::MatchRecord& record = match.record;
  if (record.frames() == 0 || !record.errors.empty()) {
    return base::Error{fmt::format("{}: {}", found.logs.game,
                                   record.frames() == 0 ? "no frame" : "the log has errors")};
  }

  LeagueLogs logs;
  logs.name = start_text(start) + gamelog::match_name(record.teams.back());
  logs.last_cycle = record.time.back();
  base::StringSink sink;
  gamelog::write_rcg(record, gamelog::RcgVersion::kV5, sink);
  logs.rcg = sink.bytes();
  if (found.logs.text.empty()) return logs;
  TRY_INIT(const auto text, base::open_source(found.logs.text));
  logs.rcl = base::read_all(*text);
  if (text->error().empty()) return logs;

  return base::Error{fmt::format("{}: {}", found.logs.text, text->error())};
}

}  // namespace cls::cli
