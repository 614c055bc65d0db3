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

}  // namespace cls::tournament
