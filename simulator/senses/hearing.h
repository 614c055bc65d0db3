// What a player hears of others: says wait until the next sense_body, then ears decide.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulator/world/event.h"
#include "soccer/messages/hear.h"

namespace cls::simulator {

/// Says on their way to one listener, its own ones too. A plain value; memory is reused.
struct Hearing {
  Hearing() { waiting.reserve(soccer::kPlayersOnPitch); }

  struct Words {
    Slot speaker = kNobody;
    std::string text;
  };
  /// More than this of one speaker in a cycle are not kept: nobody who plays says so much.
  static constexpr int kMostOfOneSpeaker = 16;

  std::vector<Words> waiting;           ///< in order of speaking
  std::vector<std::string> of_trainer;  ///< heard by all, before anything else
};

/// A player has spoken: keeps it if the listener is on the pitch, near enough and has an ear for
/// that side (simulation model 8.2). Speakers hear themselves.
void overhear(const World& world, const PlayerSaid& said, Slot listener, Hearing& hearing);

/// After sense_body: appends to `out` what the listener hears of all that waits: the trainer's
/// words, own words, then as attention and capacity (which it uses up) allow. `choice` picks among
/// several.
void hear(World& world, Slot listener, Hearing& hearing, RandomStream& choice,
          std::vector<soccer::Hear>& out);

}  // namespace cls::simulator
