// Where a match folder has what pages show about decisions.
#pragma once

#include <cstddef>

namespace cls::viewer {

/// Names inside a match folder: a stream of DecisionWriter each, compressed with gzip.
inline constexpr const char* kLeftWorldModelsFile = "left.world-models";
inline constexpr const char* kRightWorldModelsFile = "right.world-models";

/// The most bytes that such a stream may have.
inline constexpr std::size_t kMaxWorldModels = std::size_t{1} << 30;

/// Lines of JSON: the decisions without a usable reply (docs/matches.md).
inline constexpr const char* kMissedFile = "missed.jsonl";

/// Lines of JSON: texts and drawings of a Playmaker (docs/actions.md); created with the first.
inline constexpr const char* kLeftDebugFile = "left-debug.jsonl";
inline constexpr const char* kRightDebugFile = "right-debug.jsonl";

}  // namespace cls::viewer
