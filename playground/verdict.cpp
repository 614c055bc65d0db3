// Pairs of a JSON array, one after the other, until the test decides.
#include "playground/verdict.h"

#include "base/index.h"
#include "base/text/json.h"
#include "base/text/json_document.h"
#include "league/rating/betting.h"
#include "league/rating/sprt.h"

namespace cls::playground {
namespace {

using base::Json;
using league::Decision;

constexpr int kMostPoints = 4;  // of a pair

league::Hypotheses usual_hypotheses() {
  league::Hypotheses usual;
  usual.mean0 = league::score_from_elo(league::kUsualElo0);
  usual.mean1 = league::score_from_elo(league::kUsualElo1);
  return usual;
}

}  // namespace

base::Result<std::string> verdict_json(std::string_view pairs) {
  TRY_INIT(const auto document, base::JsonDocument::parse("pairs", std::string(pairs)));
  const base::JsonValue root(document);
  if (!root.is_array()) return root.error("must be an array of points");

  const league::Hypotheses hypotheses = usual_hypotheses();
  league::BettingTest test(hypotheses);
  league::Frequencies outcomes(kMostPoints + 1, 0.0);
  for (std::size_t i = 0; i < root.size() && test.decision() == Decision::kOpen; ++i) {
    TRY_INIT(const int points, root[i].integer(0, kMostPoints));
    outcomes[base::index(points)] += 1;
    test.add(static_cast<double>(points) / kMostPoints);
  }

  const league::Estimate strength = league::estimate(outcomes);
  const Json verdict = {{"pairs", strength.count},
                        {"outcomes", outcomes},
                        {"decision", league::name(test.decision())},
                        {"score", strength.score},
                        {"elo", strength.elo},
                        {"eloInterval", {strength.elo_interval.low, strength.elo_interval.high}},
                        {"superiority", strength.superiority},
                        {"forH1", test.for_h1()},
                        {"forH0", test.for_h0()},
                        {"needed", 1 / hypotheses.alpha},
                        {"elo0", league::kUsualElo0},
                        {"elo1", league::kUsualElo1}};
  return verdict.dump();
}

}  // namespace cls::playground
