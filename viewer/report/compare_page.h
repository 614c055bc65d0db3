// A page with two matches side by side.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gamelog/record/match_record.h"
#include "viewer/page/page.h"
#include "viewer/report/match_difference.h"

namespace cls::viewer {

/// The page: a page of the first match (match_page.h), from which read_page() reads that match,
/// with the second one and the differences in it, and the texts and drawings of both.
std::string compare_page(const gamelog::MatchRecord& first, const ComparedMatch& a,
                         const gamelog::MatchRecord& second, const ComparedMatch& b,
                         const std::array<std::vector<PageDrawings>, 2>& drawings = {});

}  // namespace cls::viewer
