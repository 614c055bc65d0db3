// The bits of a player's state in game logs.
#pragma once

#include <cstdint>

namespace cls::gamelog {

// Log-formats 1.3. The bits of actions last one frame, those of a tackle or a foul as long as the
// player cannot move, cards and kGoalie for ever. Versions 1 to 3 have the low sixteen bits only.
constexpr std::uint32_t kStateEnabled = 0x1;  ///< without it a slot counts as not connected
constexpr std::uint32_t kStateKick = 0x2;
constexpr std::uint32_t kStateKickFailed = 0x4;  ///< always with kStateKick
constexpr std::uint32_t kStateGoalie = 0x8;
constexpr std::uint32_t kStateCatch = 0x10;
constexpr std::uint32_t kStateCatchFailed = 0x20;  ///< always with kStateCatch
constexpr std::uint32_t kStateBallContact = 0x40;
constexpr std::uint32_t kStateBallCollision = 0x400;
constexpr std::uint32_t kStateTackle = 0x1000;
constexpr std::uint32_t kStateTackleFailed = 0x2000;  ///< alone: out of reach
constexpr std::uint32_t kStateBackPass = 0x4000;
constexpr std::uint32_t kStateFreeKickFault = 0x8000;
constexpr std::uint32_t kStateHitPost = 0x10000;
constexpr std::uint32_t kStateCharged = 0x20000;  ///< cannot move after a foul against him
constexpr std::uint32_t kStateYellowCard = 0x40000;
constexpr std::uint32_t kStateRedCard = 0x80000;
constexpr std::uint32_t kStateIllegalDefense = 0x100000;

}  // namespace cls::gamelog
