// Reads and replaces the whole file: it has few lines.
#include "orchestration/tournament/store/pauses_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/catch_as_error.h"
#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "base/text/json_text.h"

namespace cls::orchestration::tournament {
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
  std::vector<Pause> pauses;
  const fs::path file = folder / kPausesFile;
  TRY_INIT(const std::string text, read_if_there(file));
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    TRY_INIT(auto pause,
             base::catch_as_error<std::exception>(fmt::format("{}:{}", file.string(), number), [&] {
               const auto json = nlohmann::json::parse(line);
               const auto& end = json.at("end");
               return Pause{json.at("begin").get<std::string>(),
                            end.is_null() ? "" : end.get<std::string>(),
                            json.at("reason").get<std::string>()};
             }));
    pauses.push_back(std::move(pause));
  }
  return pauses;
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

}  // namespace cls::orchestration::tournament
