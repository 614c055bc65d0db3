// The decisions of a match that `cls review` has played again, for its page.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "base/text/json.h"

namespace cls::viewer {

/// From the document `cls.review/1` (docs/review.md) the decisions in the match of the game log
/// `log` that have a better alternative, as the settings of a page have them
/// (docs/formats/view.md). The error says that the text is something else, or has no decision of
/// this match.
base::Result<base::Json> page_review(std::string_view document, const std::string& log);

}  // namespace cls::viewer
