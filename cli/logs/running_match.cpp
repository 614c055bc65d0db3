// Judges by files and their ages.
#include "cli/logs/running_match.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "base/io/whole_file.h"
#include "base/system/socket_address.h"
#include "base/text/number_text.h"
#include "cli/logs/find_match_folder.h"
#include "match/result/match_folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
namespace match = match;

// The log of a running match may rest this long, for example under a debugger.
constexpr std::chrono::seconds kRunningLogAge{30};

bool changed_lately(const fs::path& file) {
  std::error_code code;
  const auto changed = fs::last_write_time(file, code);
  return !code && fs::file_time_type::clock::now() - changed < kRunningLogAge;
}

// A match that was killed has no result either, but an old log.
std::optional<FollowedMatch> in_folder(const std::string& what) {
  const auto found = find_match_folder(what, std::nullopt);
  if (!found || match::has_result(found->folder)) return std::nullopt;

  const fs::path folder = found->folder;
  const fs::path log = match::game_log_in(folder);
  if (!changed_lately(log) && !changed_lately(folder / match::kManifestFile)) return std::nullopt;
  return FollowedMatch{viewer::follow_log(log, [folder] { return match::has_result(folder); }),
                       folder / match::kTextLogFile, folder.filename().string(), folder};
}

// The number in HOST:PORT, unless there is a file of that name.
std::optional<int> server_port(const std::string& what) {
  std::error_code code;
  const std::size_t colon = what.rfind(':');
  if (colon == std::string::npos || colon == 0 || what.find('/') != std::string::npos) return {};
  const auto port = base::parse_int(std::string_view(what).substr(colon + 1));
  return fs::exists(what, code) ? std::nullopt : port;
}

base::Result<std::optional<FollowedMatch>> on_server(const std::string& what) {
  const auto port = server_port(what);
  if (!port) return std::optional<FollowedMatch>();
  if (*port < 1 || *port > 65535) {
    return base::Error{fmt::format("{}: a port is a number from 1 to 65535", what)};
  }

  const std::string host = base::strip_brackets(what.substr(0, what.rfind(':')));
  TRY_INIT(auto input, viewer::follow_server(host, *port));
  return std::optional(FollowedMatch{std::move(input), {}, what, {}});
}

}  // namespace

bool names_server(const std::string& what) { return server_port(what).has_value(); }

base::Result<std::optional<FollowedMatch>> find_running_match(const std::string& what,
                                                              bool is_live_log) {
  std::error_code code;
  if (fs::is_directory(what, code)) return in_folder(what);
  if (what != "-") {
    auto found = on_server(what);
    if (!found || *found) return found;
  }

  if (!is_live_log) return std::optional<FollowedMatch>();
  if (const auto why = base::why_no_file(what)) {
    return base::Error{fmt::format("{}: {}", what, *why)};
  }
  return std::optional(
      FollowedMatch{viewer::follow_log(what, nullptr), {}, fs::path(what).filename().string(), {}});
}

}  // namespace cls::cli
