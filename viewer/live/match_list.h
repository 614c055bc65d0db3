// The page of many matches: who plays whom, scores, and a link to each.
#pragma once

#include <string>
#include <vector>

namespace cls::viewer {

struct ListedMatch {
  int index = 0;  ///< its page is at "match/INDEX/"
  std::string left;
  std::string right;
  std::string score;  ///< "2 : 1"; empty before the end
  std::string state;  ///< "playing", "failed: ..."; empty: finished
  bool has_page = false;
};

/// HTML without scripts. While `running`, browsers load it again every few seconds.
std::string match_list_page(const std::string& title, const std::vector<ListedMatch>& matches,
                            bool running);

}  // namespace cls::viewer
