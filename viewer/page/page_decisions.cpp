// Unpacks, selects, packs again.
#include "viewer/page/page_decisions.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/lines.h"
#include "base/text/number_text.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/page/encoding.h"

namespace cls::viewer {
namespace {

// Uniform numbers of the players of a side.
std::vector<int> numbers_of(const std::vector<std::string>& players, soccer::Side side) {
  std::vector<int> numbers;
  for (const std::string& player : players) {
    if (player.empty() || player[0] != soccer::letter(side)) continue;
    if (const auto unum = base::parse_int(std::string_view(player).substr(1))) {
      numbers.push_back(*unum);
    }
  }
  return numbers;
}

std::optional<MissedDecision> missed_of(std::string_view line) {
  const auto json = base::Json::parse_or_discarded(line);
  if (!json.is_object()) return std::nullopt;

  const auto integer = [&](const char* key) {
    const auto found = json.find(key);
    return found != nullptr && found->is_number_integer() ? found->get<int>() : -1;
  };
  const auto text = [&](const char* key) {
    const auto found = json.find(key);
    return found != nullptr && found->is_string() ? found->get<std::string>() : std::string();
  };

  const auto side = soccer::parse_side(text("side"));
  const int unum = integer("unum");
  if (!side || !soccer::is_unum(unum) || integer("t") < 0) return std::nullopt;
  return MissedDecision{integer("t"), std::max(0, integer("stopped")),
                        soccer::letter(*side) + std::to_string(unum), text("reason")};
}

base::Result<std::string> read_packed(const std::filesystem::path& file) {
  if (auto packed = base::read_file(file)) return *std::move(packed);
  return base::Error{file.string() + ": " + base::why_no_file(file).value_or("cannot be read")};
}

// Recorded decisions of a side, compressed, as far as they are chosen.
base::Result<std::string> chosen_part(std::string packed, const std::vector<int>& numbers,
                                      const std::vector<CycleRange>& cycles) {
  TRY_INIT(const auto stream, gunzip(packed, kMaxWorldModels));
  TRY_INIT(const auto players, select_players(stream, numbers));
  TRY_INIT(const auto selected, select_cycles(players, cycles));

  const bool all = numbers.empty() && cycles.empty();
  return all ? std::move(packed) : gzip(selected);
}

}  // namespace

base::Result<TeamDecisions> read_recorded_decisions(const std::filesystem::path& file) {
  TRY_INIT(const auto packed, read_packed(file));
  const auto stream = gunzip(packed, kMaxWorldModels);
  auto team = stream ? read_decisions(*stream) : stream.error();
  if (!team) return base::Error{file.string() + ": " + team.error().message};
  return team;
}

std::vector<MissedDecision> read_missed_decisions(const std::filesystem::path& folder) {
  const std::string text = base::read_file(folder / kMissedFile).value_or("");
  std::vector<MissedDecision> missed;
  for (const std::string_view line : base::lines_of(text)) {
    if (auto one = missed_of(line)) missed.push_back(*std::move(one));
  }
  return missed;
}

base::Result<std::vector<PageDecisions>> read_page_decisions(const std::filesystem::path& folder,
                                                             const DecisionChoice& choice) {
  std::vector<PageDecisions> decisions;
  for (const auto& [side, name] : {std::pair(soccer::Side::kLeft, kLeftWorldModelsFile),
                                   std::pair(soccer::Side::kRight, kRightWorldModelsFile)}) {
    const std::vector<int> numbers = numbers_of(choice.players, side);
    if (!choice.players.empty() && numbers.empty()) continue;

    std::error_code code;
    if (!std::filesystem::exists(folder / name, code) && !code) continue;
    TRY_INIT(auto packed, read_packed(folder / name));
    auto chosen = chosen_part(std::move(packed), numbers, choice.cycles);
    if (!chosen) {
      return base::Error{(folder / name).string() + ": " + chosen.error().message};
    }
    decisions.push_back({side, *std::move(chosen)});
  }
  return decisions;
}

}  // namespace cls::viewer
