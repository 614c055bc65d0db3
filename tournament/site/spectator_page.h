// The page for spectators of a tournament: plain data, and the HTML that shows it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viewer/live/log_glance.h"

namespace cls::tournament {

/// A match as spectators see it. Texts are escaped by the page.
struct SpectatorMatch {
  int index = 0;         ///< its page is at "match/INDEX/"
  std::string occasion;  ///< "first round, group A"; may be empty
  std::string left;
  std::string right;
  std::string start;  ///< "2027-07-15 09:00", expected; empty: unknown, or it has begun
  std::string score;  ///< "2:1", "0:3 (forfeit)"; empty before the match
  bool has_page = false;
  std::optional<viewer::Glance> glance = {};  ///< of a match that is played now
};

/// Things under one heading: tables of a stage, results of a stage.
template <typename Content>
struct SpectatorGroup {
  std::string title;
  std::vector<Content> content;
};

struct SpectatorPage {
  std::string title;
  std::string status;  ///< "12 of 40 matches played"
  bool over = false;
  std::string winner;  ///< of the tournament, once it is over
  std::string pause;   ///< "Technical time-out since 2027-07-15 09:10"; empty: there is none
  std::vector<SpectatorMatch> running;
  std::vector<SpectatorMatch> next;  ///< in the order of the schedule
  int further = 0;                   ///< planned matches beyond `next`
  std::vector<std::string> tables;   ///< <table> elements of what is played now
  std::vector<SpectatorGroup<std::string>> earlier_tables;
  std::string bracket;                                  ///< HTML of bracket_html(), may be empty
  std::vector<SpectatorGroup<SpectatorMatch>> results;  ///< the latest first
  std::vector<std::string> statistics;                  ///< <table> elements
};

/// The whole page; `rest` identifies all but the matches that are played now. Its script fetches
/// spectator_now() every second and the page again when the rest has changed; browsers without
/// scripts load the page again. All addresses are relative, so the page may be anywhere below a
/// path of a proxy.
std::string spectator_page(const SpectatorPage& page, const std::string& rest);

/// The matches that are played now, as a fragment of HTML.
std::string spectator_now(const SpectatorPage& page, const std::string& rest);

}  // namespace cls::tournament
