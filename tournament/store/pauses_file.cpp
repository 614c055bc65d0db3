// Reads and replaces the whole file: it has few lines.
#include "tournament/store/pauses_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "base/text/json_text.h"
#include "tournament/store/folder.h"
#include "tournament/store/json_lines.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Result;

Result<void> write_pauses(const fs::path& folder, const std::vector<Pause>& pauses) {
  std::string text;
  for (const Pause& pause : pauses) {
    const nlohmann::ordered_json line = {
        {"begin", pause.begin},
        {"end",
         pause.end.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(pause.end)},
        {"reason", pause.reason}};
    text += base::json_line(line) + "\n";
  }
  return base::write_file_durably(folder / kPausesFile, text);
}

}  // namespace

Result<std::vector<Pause>> read_pauses(const fs::path& folder) {
  return read_json_lines(folder / kPausesFile, [](const std::string& line) {
    const auto json = nlohmann::json::parse(line);
    const auto& end = json.at("end");
    return Pause{json.at("begin").get<std::string>(), end.is_null() ? "" : end.get<std::string>(),
                 json.at("reason").get<std::string>()};
  });
}

bool is_paused(const std::vector<Pause>& pauses) {
  return !pauses.empty() && pauses.back().end.empty();
}

Result<bool> begin_pause(const fs::path& folder, const std::string& reason) {
  TRY_INIT(auto pauses, read_pauses(folder));
  if (is_paused(pauses)) return false;
  pauses.push_back({base::utc_now(), "", reason});
  TRY(write_pauses(folder, pauses));
  return true;
}

Result<bool> end_pause(const fs::path& folder) {
  TRY_INIT(auto pauses, read_pauses(folder));
  if (!is_paused(pauses)) return false;
  pauses.back().end = base::utc_now();
  TRY(write_pauses(folder, pauses));
  return true;
}

}  // namespace cls::tournament
