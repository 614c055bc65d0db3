// Reads and replaces the whole file: it has few lines.
#include "tournament/store/pauses_file.h"

#include "base/system/host.h"
#include "tournament/store/json_lines.h"

namespace cls::tournament {
namespace fs = std::filesystem;
using base::Result;

template <typename Codec>
static void members(Codec& codec, typename Codec::template Object<Pause>& pause) {
  codec.required("begin", pause.begin);
  codec.text_or_null("end", pause.end);
  codec.required("reason", pause.reason);
}

namespace {

Result<void> write_pauses(const fs::path& folder, const std::vector<Pause>& pauses) {
  return write_json_lines(folder / kPausesFile, pauses);
}

}  // namespace

Result<std::vector<Pause>> read_pauses(const fs::path& folder) {
  return read_json_lines<Pause>(folder / kPausesFile);
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
