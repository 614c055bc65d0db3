// Saved matches: `--save-at` and `--resume`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "base/result.h"
#include "match/terms/match_options.h"
#include "proto/saved_match.pb.h"
#include "proxy/playmaker/resumed_playmaker.h"
#include "simulator/world/world.h"
#include "soccer/side.h"

namespace cls::match {

/// The number of a side in saved matches and recordings: 1 left, 2 right.
constexpr int side_number(soccer::Side side) { return side == soccer::Side::kRight ? 2 : 1; }

/// The terms of a match to be saved, without cycle and replies.
saved::SavedMatch describe_match(const MatchOptions& options, std::uint64_t seed,
                                 const TeamNames& names);

/// The error names the file.
base::Result<std::shared_ptr<const saved::SavedMatch>> read_saved_match(
    const std::filesystem::path& file);

/// Takes seed, names and parameters from the file. The seed of the options, if there is one, is
/// that of the random draws after the saved step.
base::Result<void> resume_from(std::shared_ptr<const saved::SavedMatch> match,
                               MatchOptions& options);

/// The saved replies of one side.
proxy::SavedReplies replies_of(const saved::SavedMatch& match, soccer::Side side);

/// Hash of time, score, ball and players.
std::uint64_t situation_of(const simulator::World& world);

}  // namespace cls::match
