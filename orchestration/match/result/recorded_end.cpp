// Reads result.json beside logs.
#include "orchestration/match/result/recorded_end.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "orchestration/match/result/match_result.h"

namespace cls::orchestration::match {
namespace {

constexpr std::uintmax_t kMaxDocumentBytes = 16 << 20;

}  // namespace

std::optional<analysis::RecordedEnd> recorded_end(const std::string& log) {
  const std::filesystem::path path(log);
  const std::filesystem::path document = path.parent_path() / "result.json";
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(document, error);
  if (error || size > kMaxDocumentBytes) return std::nullopt;
  std::ifstream file(document, std::ios::binary);
  const auto result = parse_match_result(std::string(std::istreambuf_iterator<char>(file), {}));
  const std::string name = path.filename().string();
  if (!result || (result->rcg != name && result->rcl != name)) return std::nullopt;
  return analysis::RecordedEnd{std::string(match::name(result->end_reason)), result->valid()};
}

std::vector<analysis::MatchInput> with_recorded_ends(
    const std::vector<gamelog::MatchLogs>& matches) {
  std::vector<analysis::MatchInput> inputs;
  for (const gamelog::MatchLogs& logs : matches) {
    inputs.push_back({logs, recorded_end(logs.game.empty() ? logs.text : logs.game)});
  }
  return inputs;
}

}  // namespace cls::orchestration::match
