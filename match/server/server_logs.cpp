// Opens, closes and renames log files.
#include "match/server/server_logs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/io/background_sink.h"
#include "base/io/disk_space.h"
#include "gamelog/rcg/rcg_writer.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;

std::string formatted(const std::string& format, std::time_t time) {
  std::tm local{};
  localtime_r(&time, &local);
  std::array<char, 256> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), format.c_str(), &local);
  return {text.data(), size};
}

}  // namespace

gamelog::LogDate log_date(std::time_t start) {
  return {formatted("%Y%m%d%H%M", start), formatted("%FT%T%z", start)};
}

/// Parameters of one log.
struct ServerLogs::Wish {
  bool wanted;
  std::string folder;
  bool fixed;
  std::string fixed_name;
  bool dated;
  int compression;
  std::string kind;  ///< "rcg"
};

Result<ServerLogs::Log> ServerLogs::open(const Wish& wish, const std::string& date) {
  Log log;
  if (!wish.wanted) return log;
  std::error_code error;
  std::filesystem::create_directories(wish.folder, error);
  if (error) {
    return Error{fmt::format("cannot create the folder {}: {}", wish.folder, error.message())};
  }

  const int level = std::clamp(wish.compression, 0, 9);
  log.ending = ("." + wish.kind).append(base::compressed_suffix(level));
  log.fixed = wish.fixed;
  if (wish.dated) log.date = date;

  const std::string name = wish.fixed ? wish.fixed_name : "incomplete";
  log.path = std::filesystem::path(wish.folder) / (name + log.ending);
  TRY_INIT(auto file, base::create_log_file(log.path.string(), level));
  log.sink = std::move(file);
  return log;
}

Result<ServerLogs> ServerLogs::open(const soccer::ServerParams& p, std::time_t start,
                                    bool keep_space) {
  const std::string date = formatted(p.log_date_format, start);
  ServerLogs logs;
  logs.version_ = gamelog::rcg_version(p.game_log_version).value_or(gamelog::RcgVersion::kV6);
  if (p.game_log_dated && !p.game_log_fixed) logs.date_ = log_date(start);

  const std::pair<Log*, Wish> wishes[] = {
      {&logs.game_,
       {p.game_logging, p.game_log_dir, p.game_log_fixed, p.game_log_fixed_name, p.game_log_dated,
        p.game_log_compression, "rcg"}},
      {&logs.text_,
       {p.text_logging, p.text_log_dir, p.text_log_fixed, p.text_log_fixed_name, p.text_log_dated,
        p.text_log_compression, "rcl"}},
      {&logs.keepaway_,
       {p.keepaway && p.keepaway_logging, p.keepaway_log_dir, p.keepaway_log_fixed,
        p.keepaway_log_fixed_name, p.keepaway_log_dated, 0, "kwy"}}};
  for (const auto& [log, wish] : wishes) {
    TRY_INIT(auto opened, open(wish, date));
    *log = std::move(opened);
    if (keep_space && log->sink != nullptr) base::reserve_space(log->path, kSpaceOfLog);
  }
  logs.keeps_space_ = keep_space;
  return logs;
}

simulator::LogSinks ServerLogs::sinks() const {
  return {game_.sink.get(), text_.sink.get(), version_, date_};
}

Result<void> ServerLogs::finish(Log& log, const std::string& match) const {
  if (log.sink == nullptr) return {};
  const auto closed = log.sink->close();
  if (keeps_space_) base::release_space(log.path);
  TRY(closed);
  if (log.fixed) return {};

  const std::filesystem::path last = log.path.parent_path() / (log.date + match + log.ending);
  std::error_code error;
  std::filesystem::rename(log.path, last, error);
  if (error) {
    return Error{fmt::format("cannot rename {}: {}", log.path.string(), error.message())};
  }
  log.path = last;
  return {};
}

Result<void> ServerLogs::finish(const gamelog::TeamFrames& teams) {
  // Team names may contain a slash.
  std::string match = gamelog::match_name(teams);
  std::ranges::replace(match, '/', '_');

  Result<void> result;
  for (Log* log : {&game_, &text_, &keepaway_}) {
    auto finished = finish(*log, match);
    if (result) result = std::move(finished);
  }
  return result;
}

std::vector<std::filesystem::path> ServerLogs::paths() const {
  std::vector<std::filesystem::path> paths;
  for (const Log* log : {&game_, &text_, &keepaway_}) {
    if (log->sink != nullptr) paths.push_back(log->path);
  }
  return paths;
}

}  // namespace cls::match
