// The page of many matches: tables, who plays whom, scores, and a link to each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "soccer/geometry.h"

namespace cls::viewer {

struct ListedMatch {
  int index = 0;  ///< its page is at "match/INDEX/"
  std::string left;
  std::string right;
  std::string score;  ///< "2 : 1"; empty: unknown
  std::string state;  ///< "finished", "cycle 1200", "failed: ..."
  bool has_page = false;
  std::optional<soccer::Vec2> ball = {};  ///< of a match that is played now
  bool live = false;                      ///< its page is a live one
};

/// A row of the table at the top: "played now", "2".
struct Fact {
  std::string name;
  std::string value;
};

struct MatchList {
  std::string title;
  std::string status;               ///< "2 of 6 matches done"
  std::vector<std::string> tables;  ///< <table> elements of base::Table, for example the standings
  std::vector<ListedMatch> matches;
  bool running = false;
  std::vector<Fact> facts = {};  ///< always the same names
};

/// HTML. While matches are running, a script fetches the page again and copies what changed into
/// it: cells change in place, rows keep theirs until the reader sorts them. Without scripts,
/// browsers load the page again.
std::string match_list_page(const MatchList& list);

}  // namespace cls::viewer
