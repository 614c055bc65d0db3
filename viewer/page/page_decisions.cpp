// Unpacks, selects, packs again.
#include "viewer/page/page_decisions.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "base/io/whole_file.h"
#include "base/text/number_text.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/decisions/decision_reader.h"
#include "viewer/page/encoding.h"

namespace cls::viewer {
namespace {

constexpr std::size_t kMaxDecisions = std::size_t{1} << 30;

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
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;

  const auto integer = [&](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number_integer() ? found->get<int>() : -1;
  };
  const auto text = [&](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  };

  const auto side = soccer::parse_side(text("side"));
  const int unum = integer("unum");
  if (!side || unum < 1 || unum > soccer::kPlayersPerTeam || integer("t") < 0) return std::nullopt;
  return MissedDecision{integer("t"), std::max(0, integer("stopped")),
                        soccer::letter(*side) + std::to_string(unum), text("reason")};
}

}  // namespace

std::vector<MissedDecision> read_missed_decisions(const std::filesystem::path& folder) {
  const std::string text = base::read_file(folder / kMissedFile).value_or("");
  std::vector<MissedDecision> missed;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (auto one = missed_of(std::string_view(text).substr(at, end - at))) {
      missed.push_back(*std::move(one));
    }
    at = end + 1;
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
    auto packed = base::read_file(folder / name);
    if (!packed) {
      const auto why = base::why_no_file(folder / name);
      return base::Error{(folder / name).string() + ": " + why.value_or("cannot be read")};
    }
    const auto in_file = [&, file = (folder / name).string()](const base::Error& error) {
      return base::Error{file + ": " + error.message};
    };

    const auto stream = gunzip(*packed, kMaxDecisions);
    if (!stream) return in_file(stream.error());
    const auto players = select_players(*stream, numbers);
    if (!players) return in_file(players.error());
    const auto selected = select_cycles(*players, choice.cycles);
    if (!selected) return in_file(selected.error());

    const bool all = numbers.empty() && choice.cycles.empty();
    decisions.push_back({side, all ? *std::move(packed) : gzip(*selected)});
  }
  return decisions;
}

}  // namespace cls::viewer
