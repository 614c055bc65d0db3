// Audio model: say messages wait for the next sense_body, then ear modes and capacity filter them.
#pragma once

#include <string>
#include <vector>

#include "simulator/world/event.h"
#include "soccer/messages/hear.h"

namespace cls::simulator {

/// Messages for one listener that wait for its next sense_body. Memory is reused.
struct PendingMessages {
  PendingMessages() { says.reserve(soccer::kPlayersOnPitch); }

  struct Say {
    Slot speaker = kNoPlayer;
    std::string text;
  };
  /// Further messages of one speaker in a cycle are dropped.
  static constexpr int kMaxMessagesPerSpeaker = 16;

  std::vector<Say> says;             ///< in order of speaking; includes the listener's own
  std::vector<std::string> trainer;  ///< delivered first, to all players
};

/// Queues a say message if the listener is on the pitch, within audio_cut_dist, and listens to that
/// side (docs/spec/simulation-model.md 8.2). Speakers hear their own messages.
void queue_say(const World& world, const PlayerSaid& said, Slot listener, PendingMessages& pending);

/// Appends the messages that the listener hears after its sense_body to `out`: the trainer's, its
/// own, then those that attention and capacity admit. Uses up hearing capacity. `choice` picks
/// among several candidates.
void hear(World& world, Slot listener, PendingMessages& pending, RandomStream& choice,
          std::vector<soccer::Hear>& out);

}  // namespace cls::simulator
