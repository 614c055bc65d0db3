// Where a match folder has its recorded decisions.
#pragma once

namespace cls::viewer {

/// Names inside a match folder: a stream of DecisionWriter each, compressed with gzip.
inline constexpr const char* kLeftWorldModelsFile = "left.world-models";
inline constexpr const char* kRightWorldModelsFile = "right.world-models";

/// Lines of JSON: the decisions without a usable reply (docs/matches.md).
inline constexpr const char* kMissedFile = "missed.jsonl";

}  // namespace cls::viewer
