// Members of a report that a rerun must reproduce.
#include "tests/support/tournament_outcome.h"

namespace cls::tests {

using json = base::Json;

json outcome_of(const json& report) {
  json matches = json::array();
  for (const json& match : report["matches"]) {
    json one;
    for (const char* key : {"index", "left", "right", "seed", "end_reason", "score", "cycles"}) {
      one[key] = match[key];
    }
    matches.push_back(one);
  }
  return {{"matches", matches}, {"standings", report["standings"]}};
}

}  // namespace cls::tests
