// What was played of a match of a tournament: what counts, and what decisions took out.
#pragma once

#include <string>
#include <vector>

#include "league/matches/fixture.h"

namespace cls::league {

/// A match that was played to its end, or whose result a decision replaced, with a match folder.
struct Playing {
  std::string folder;     ///< in the tournament
  std::string began;      ///< UTC, ISO 8601
  bool annulled = false;  ///< by decision: another playing counts, or none
};

/// The one that counts is first, if there is one. Each folder is listed once.
std::vector<Playing> playings_of(const ScheduledMatch& match);

}  // namespace cls::league
