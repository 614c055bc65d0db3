// The description of a data set for its readers.
#pragma once

#include <string>
#include <vector>

#include "tournament/config/config.h"
#include "tournament/dataset/dataset.h"

namespace cls::tournament {

/// The card as Markdown: contents, sides, seeds, versions, how it was made and how to read it. It
/// depends on its arguments only.
std::string data_card(const TournamentConfig& config, const std::vector<DatasetMatch>& matches);

/// What a data set of equal sides has twice, in one line: a split into training and test leaks.
/// Empty: no two teams have the same endpoint, or each pair is played once.
std::string twin_sides(const TournamentConfig& config);

}  // namespace cls::tournament
