// Reads the decisions of a document back.
#include "review/saved_decisions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/system/version.h"

namespace cls::review {
namespace {

using base::Json;

// The first member that differs: "--seeds: 40 there, 20 here".
std::optional<std::string> difference(const Json& document, const Review& review) {
  const std::pair<const char*, Json> terms[] = {
      {"the team", review.team},           {"the version", std::string(base::kVersion)},
      {"--continue", review.continued_by}, {"--seeds", review.terms.seeds},
      {"--seed", review.terms.seed},       {"--cycles", review.terms.cycles},
  };
  const Json there[] = {document.at("team"),  document.at("version"), document.at("continued_by"),
                        document.at("seeds"), document.at("seed"),    document.at("cycles")};
  for (std::size_t i = 0; i < std::size(terms); ++i) {
    const auto& [name, here] = terms[i];
    const std::string found = there[i].dump();
    if (found != here.dump()) {
      return fmt::format("{}: {} there, {} here", name, found, here.dump());
    }
  }
  return std::nullopt;
}

Worths worths_of(const Json& list) {
  Worths worths;
  for (const Json& worth : list) worths.push_back(worth.get<double>());
  return worths;
}

}  // namespace

SavedDecisions::Saved SavedDecisions::read_decision(const Json& decision, const Json& matches) {
  Saved saved;
  saved.file = matches.at(decision.at("match").get<std::size_t>()).at("file").get<std::string>();
  saved.cycle = decision.at("cycle").get<int>();
  saved.unum = decision.at("unum").get<int>();
  saved.before = decision.at("value_before").get<double>();
  saved.after = decision.at("value_after").get<double>();
  saved.recorded = worths_of(decision.at("worths"));

  for (const Json& one : decision.at("alternatives")) {
    Alternative alternative;
    alternative.text = one.at("decision").get<std::string>();
    alternative.group = one.at("kind").get<std::string>();
    alternative.planned = one.at("planner").get<bool>();
    const Json& target = one.at("target");
    alternative.target = {target.at(0).get<double>(), target.at(1).get<double>()};
    saved.alternatives.push_back(std::move(alternative));

    saved.worths.push_back(worths_of(one.at("worths")));
    if (saved.worths.back().size() != saved.recorded.size()) throw Json::exception("worths");
  }
  return saved;
}

base::Result<SavedDecisions> SavedDecisions::read(const Json& document, const Review& review) {
  try {
    if (document.at("schema") != Json(kReviewSchema)) return base::Error{"is another document"};
    if (auto differs = difference(document, review)) return base::Error{*std::move(differs)};

    SavedDecisions saved;
    for (const Json& decision : document.at("decisions")) {
      saved.decisions_.push_back(read_decision(decision, document.at("matches")));
      saved.files_.insert(saved.decisions_.back().file);
    }
    return saved;
  } catch (const Json::exception& damage) {
    return base::Error{fmt::format("is not a review: {}", damage.what())};
  }
}

std::optional<PlayedDecision> SavedDecisions::find(const std::string& file,
                                                   const Decision& decision) const {
  const auto same = [&](const Saved& saved) {
    return saved.file == file && saved.cycle == decision.cycle &&
           saved.unum == soccer::unum_of_slot(decision.slot) && saved.before == decision.before &&
           saved.after == decision.after;
  };
  const auto found = std::ranges::find_if(decisions_, same);
  if (found == decisions_.end()) return std::nullopt;
  return PlayedDecision{decision, found->alternatives, found->recorded, found->worths};
}

}  // namespace cls::review
