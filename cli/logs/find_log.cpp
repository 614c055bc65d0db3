// Searches folders for logs.
#include "cli/logs/find_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "base/io/whole_file.h"
#include "cli/logs/find_match_folder.h"
#include "gamelog/rcl/rcl_reader.h"
#include "process/command_plan.h"
#include "viewer/page/page.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

std::string without_log_suffix(std::string_view file) {
  std::string_view name = gamelog::unpacked_name(file);
  for (const std::string_view suffix : {".rcg", ".json", ".html"}) {
    if (name.ends_with(suffix)) name.remove_suffix(suffix.size());
  }
  return std::string(name);
}

Result<FoundLog> find_in_folder(const fs::path& folder) {
  auto match = find_match_folder(folder, std::nullopt, WantedMatch::kWithGameLog);
  fs::path where = folder;
  if (match) where = match->folder;

  const gamelog::FoundLogs found = gamelog::find_logs({where.string()});
  const auto has_game = [](const gamelog::MatchLogs& one) { return !one.game.empty(); };
  const auto first = std::ranges::find_if(found.matches, has_game);
  if (first == found.matches.end()) {
    if (!match) return match.error();
    return Error{
        fmt::format("{}: no game log (*.rcg, *.rcg.gz); cls logs {} says how the match ended",
                    where.string(), process::shell_quoted(where.string()))};
  }
  if (!match && found.matches.size() > 1) {
    std::error_code code;
    const fs::path runs = folder / "runs";  // of a project
    return Error{fmt::format(
        "{}: {} logs; name one, such as {}", where.string(), found.matches.size(),
        fs::is_directory(runs, code) ? runs.string() + " for the latest match" : first->game)};
  }

  return FoundLog{*first, where, "match"};
}

std::string start_of(const fs::path& file) {
  std::array<char, 32> bytes{};
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(in.gcount())};
}

}  // namespace

Result<FoundLog> find_log(const std::string& what) {
  std::error_code code;
  if (fs::is_directory(what, code)) return find_in_folder(what);
  if (what == "-") return FoundLog{{what, ""}, "", "match"};

  if (gamelog::is_text_log(what)) {
    return Error{fmt::format("{}: a text log; name the game log (rcg) beside it", what)};
  }
  if (const auto why = base::why_no_file(what)) return Error{fmt::format("{}: {}", what, *why)};

  const gamelog::FoundLogs found = gamelog::find_logs({what});
  const fs::path path(what);
  const gamelog::MatchLogs logs =
      found.matches.size() == 1 ? found.matches.front() : gamelog::MatchLogs{what, ""};

  return FoundLog{logs, path.parent_path(), without_log_suffix(path.filename().string())};
}

std::optional<gamelog::RclRecord> read_text_log(const FoundLog& found) {
  if (found.logs.text.empty()) return std::nullopt;
  auto text = gamelog::read_rcl_file(found.logs.text);
  return text ? std::optional(*std::move(text)) : std::nullopt;
}

std::optional<std::string> why_no_page(const fs::path& file) {
  std::error_code code;
  if (!fs::exists(file, code)) return std::nullopt;

  if (fs::is_directory(file, code)) return fmt::format("{}: a folder, not a file", file.string());
  if (viewer::looks_like_page(start_of(file))) return std::nullopt;
  return fmt::format("{}: exists and is not a page of cls; name another file with --out",
                     file.string());
}

Result<void> write_beside(const fs::path& file, const std::string& text,
                          const std::string& out_option) {
  auto written = base::write_file(file, text);
  if (written || !out_option.empty()) return written;
  return Error{written.error().message + "; --out selects another place"};
}

}  // namespace cls::cli
