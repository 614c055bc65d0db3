// Lines of decisions.jsonl.
#include "tournament/store/decisions_file.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "base/io/whole_file.h"
#include "base/text/json_codec.h"
#include "base/text/json_text.h"
#include "tournament/store/json_lines.h"

namespace cls::tournament {
namespace {

constexpr std::array kDecisionKinds = {DecisionKind::kAnnul, DecisionKind::kReplay,
                                       DecisionKind::kAward, DecisionKind::kAsPlayed};

std::optional<DecisionKind> parse_decision_kind(std::string_view text) {
  for (const DecisionKind kind : kDecisionKinds) {
    if (name(kind) == text) return kind;
  }
  return std::nullopt;
}

}  // namespace

template <typename Codec>
static void members(Codec& codec, typename Codec::template Object<MatchDecision>& decision) {
  codec.required("match", decision.match);
  codec.named(
      "kind", decision.kind, [](DecisionKind kind) { return name(kind); }, parse_decision_kind);
  codec.pair("score", decision.left_score, decision.right_score);
  codec.pair("penalty_score", decision.left_penalties, decision.right_penalties);
  codec.member("seed", decision.seed);
  codec.member("reason", decision.reason);
  codec.text_or_null("before", decision.before);
  codec.member("time", decision.time);
}

nlohmann::ordered_json json_of(const MatchDecision& decision) {
  return base::JsonEncoder::encode(decision);
}

base::Result<std::vector<MatchDecision>> read_decisions(const std::filesystem::path& folder) {
  return read_json_lines(folder / kDecisionsFile, [](const std::string& line) {
    MatchDecision decision;
    base::JsonDecoder::decode(nlohmann::ordered_json::parse(line), decision);
    return decision;
  });
}

base::Result<void> write_decisions(const std::filesystem::path& folder,
                                   const std::vector<MatchDecision>& decisions) {
  std::string text;
  for (const MatchDecision& decision : decisions) text += base::json_line(json_of(decision)) + "\n";
  return base::write_file_durably(folder / kDecisionsFile, text);
}

}  // namespace cls::tournament
