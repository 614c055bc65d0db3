// Turns decisions into what the page shows of them.
#include "viewer/page/page_review.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "soccer/side.h"

namespace cls::viewer {
namespace {

using base::Json;

bool same_file(const std::string& a, const std::string& b) {
  std::error_code code;
  return a == b || std::filesystem::equivalent(a, b, code);
}

// `sign`: -1 for the right team, which sees the pitch turned.
Json choice_json(const std::string& text, const Json& target, double sign, const Json& worths) {
  Json at;
  if (!target.is_null()) {
    at = {sign * target.at(0).get<double>(), sign * target.at(1).get<double>()};
  }
  return {{"text", text}, {"target", at}, {"worths", worths}};
}

Json decision_json(const Json& decision, soccer::Side side) {
  const double sign = side == soccer::Side::kRight ? -1.0 : 1.0;
  const auto did = decision.at("decision").get<std::string>();
  Json choices = Json::array({choice_json(did, Json(), sign, decision.at("worths"))});
  std::size_t better = 0;
  for (const Json& one : decision.at("alternatives")) {
    if (one.at("decision") == decision.at("better")) better = choices.size();
    choices.push_back(choice_json(one.at("decision").get<std::string>(), one.at("target"), sign,
                                  one.at("worths")));
  }

  const Json& cost = decision.at("cost");
  return {{"cycle", decision.at("cycle")},
          {"player", fmt::format("{}{}", soccer::letter(side), decision.at("unum").get<int>())},
          {"cost", {cost.at("value"), cost.at("low"), cost.at("high")}},
          {"better", better},
          {"choices", choices}};
}

Json decisions_of(const Json& document, const std::string& log) {
  Json found = Json::array();
  const Json& matches = document.at("matches");
  for (const Json& decision : document.at("decisions")) {
    const Json& match = matches.at(decision.at("match").get<std::size_t>());
    if (!same_file(match.at("file").get<std::string>(), log)) continue;
    const auto side = soccer::parse_side(match.at("side").get<std::string>());
    if (side && !decision.at("better").is_null()) found.push_back(decision_json(decision, *side));
  }
  return found;
}

}  // namespace

base::Result<Json> page_review(std::string_view document, const std::string& log) {
  try {
    const Json json = Json::parse(document);
    if (json.at("schema") != Json("cls.review/1")) return base::Error{"is not a review"};
    Json decisions = decisions_of(json, log);
    if (decisions.empty()) {
      return base::Error{fmt::format("has no decision of {} that another one is better than", log)};
    }
    return decisions;
  } catch (const Json::exception& damage) {
    return base::Error{fmt::format("is not a review: {}", damage.what())};
  }
}

}  // namespace cls::viewer
