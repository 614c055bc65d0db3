// Lines of decisions.jsonl.
#include "tournament/store/decisions_file.h"

#include <fmt/format.h>

#include "tournament/store/json_lines.h"

// Where argument-dependent lookup finds it.
namespace cls::league {

template <typename Codec>
static void members(Codec& codec, typename Codec::template Object<MatchDecision>& decision) {
  codec.required("match", decision.match);
  codec.named(
      "kind", decision.kind, [](DecisionKind kind) { return name(kind); },
      [](std::string_view text) { return kDecisionKinds.parse(text); });
  codec.pair("score", decision.left_score, decision.right_score);
  codec.pair("penalty_score", decision.left_penalties, decision.right_penalties);
  codec.member("seed", decision.seed);
  codec.member("teams", decision.teams);
  codec.text_or_null("table", decision.table);
  codec.member("reason", decision.reason);
  codec.text_or_null("before", decision.before);
  codec.text_or_null("folder", decision.folder);
  codec.text_or_null("began", decision.began);
  codec.member("time", decision.time);
}

}  // namespace cls::league

namespace cls::tournament {

base::Json json_of(const MatchDecision& decision) { return base::JsonEncoder::encode(decision); }

base::Result<std::vector<MatchDecision>> read_decisions(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kDecisionsFile;
  TRY_INIT(auto decisions, read_json_lines<MatchDecision>(file));
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    if (!is_about_teams(decisions[i].kind) || !decisions[i].teams.empty()) continue;
    return base::Error{fmt::format("{}:{}: teams: must name a team", file.string(), i + 1)};
  }
  return decisions;
}

base::Result<void> write_decisions(const std::filesystem::path& folder,
                                   const std::vector<MatchDecision>& decisions) {
  return write_json_lines(folder / kDecisionsFile, decisions);
}

}  // namespace cls::tournament
