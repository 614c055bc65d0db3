// Audio model: distance, ear modes, attention and capacity (docs/spec/simulation-model.md 8).
#include "simulator/senses/hearing.h"

#include <algorithm>

#include "simulator/world/angles.h"
#include "soccer/math.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

std::size_t index(Side side) { return side == Side::kRight ? 1 : 0; }

/// Removes and returns the next message: one of the attended player if there is any, else a random
/// one.
PendingMessages::Say take_next(const Player& listener, std::vector<PendingMessages::Say>& says,
                               RandomStream& choice) {
  const auto is_attended = [&](const PendingMessages::Say& say) {
    return say.speaker == listener.attention;
  };

  auto count = std::ranges::count_if(says, is_attended);
  const bool attended = count > 0;
  if (!attended) count = static_cast<std::ptrdiff_t>(says.size());

  int skip = choice.integer(static_cast<int>(count));
  auto chosen = says.begin();
  while ((attended && !is_attended(*chosen)) || skip-- > 0) ++chosen;

  PendingMessages::Say say = std::move(*chosen);
  says.erase(chosen);
  return say;
}

int direction_to(const Player& listener, const Player& speaker) {
  return truncated_degrees(math::normalize_radians(
      soccer::direction_radians(speaker.position - listener.position) - listener.body));
}

soccer::Hear make_hear(const World& world, const Player& listener, const Player& speaker) {
  return {.time = world.clock.time,
          .sender = speaker.side == listener.side ? soccer::Hear::Sender::kTeammate
                                                  : soccer::Hear::Sender::kOpponent,
          .unum = speaker.unum};
}

void hear_trainer(const World& world, std::vector<std::string>& messages,
                  std::vector<soccer::Hear>& out) {
  for (std::string& message : messages) {
    out.push_back({.time = world.clock.time,
                   .sender = soccer::Hear::Sender::kTrainer,
                   .text = std::move(message)});
  }

  messages.clear();
}

void hear_own_says(const World& world, Slot listener, std::vector<PendingMessages::Say>& says,
                   std::vector<soccer::Hear>& out) {
  for (PendingMessages::Say& say : says) {
    if (say.speaker != listener) continue;
    out.push_back({.time = world.clock.time,
                   .sender = soccer::Hear::Sender::kSelf,
                   .text = std::move(say.text)});
  }
  std::erase_if(says, [=](const PendingMessages::Say& say) { return say.speaker == listener; });
}

}  // namespace

void queue_say(const World& world, const PlayerSaid& said, Slot listener,
               PendingMessages& pending) {
  const Player& player = world.player(listener);
  if (!player.enabled) return;

  if (listener != said.speaker) {
    const double reach = world.params().audio_cut_dist;
    if (soccer::distance(player.position, said.position) > reach) return;
    const std::size_t side = index(soccer::side_of_slot(said.speaker));
    if (!player.ears.complete[side] && !player.ears.partial[side]) return;
  }

  if (std::ranges::count(pending.says, said.speaker, &PendingMessages::Say::speaker) <
      PendingMessages::kMaxMessagesPerSpeaker) {
    pending.says.push_back({said.speaker, said.text});
  }
}

void hear(World& world, Slot slot, PendingMessages& pending, RandomStream& choice,
          std::vector<soccer::Hear>& out) {
  hear_trainer(world, pending.trainer, out);
  hear_own_says(world, slot, pending.says, out);

  Player& listener = world.player(slot);
  const int cost = world.params().hear_decay;
  while (!pending.says.empty()) {
    PendingMessages::Say say = take_next(listener, pending.says, choice);
    const Player& speaker = world.player(say.speaker);
    const std::size_t side = index(speaker.side);
    int& capacity = speaker.side == listener.side ? listener.ears.teammate_capacity
                                                  : listener.ears.opponent_capacity;

    if (capacity >= cost) {
      if (!listener.ears.complete[side]) continue;
      capacity -= cost;
      out.push_back(make_hear(world, listener, speaker));
      out.back().direction = direction_to(listener, speaker);
      out.back().text = std::move(say.text);
    } else if (listener.ears.partial[side]) {
      out.push_back(make_hear(world, listener, speaker));
      out.back().partial = true;
    }
  }
}

}  // namespace cls::simulator
