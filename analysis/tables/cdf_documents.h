// The documents of the Common Data Format about a match: match sheet and meta data.
#pragma once

#include <string>

#include "analysis/tables/cdf_match.h"

namespace cls::analysis {

/// Official match data: result, teams, goals and cards (docs/data.md). One line of JSON.
std::string cdf_match_document(const CdfMatch& match);

/// Meta data: periods with their frames and times, teams, pitch. One line of JSON.
std::string cdf_meta_document(const CdfMatch& match);

}  // namespace cls::analysis
