// Ears: distance, modes, attention and capacity (simulation model 8).
#include "simulator/senses/hearing.h"

#include <algorithm>

#include "simulator/world/angles.h"
#include "soccer/math.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

std::size_t index(Side side) { return side == Side::kRight ? 1 : 0; }

/// Takes the next words: of the attended player while there are any, else of anybody.
Hearing::Words take_next(const Player& listener, std::vector<Hearing::Words>& waiting,
                         RandomStream& choice) {
  const auto is_attended = [&](const Hearing::Words& words) {
    return words.speaker == listener.attention;
  };
  auto count = std::count_if(waiting.begin(), waiting.end(), is_attended);
  const bool attended = count > 0;
  if (!attended) count = static_cast<std::ptrdiff_t>(waiting.size());
  int skip = choice.integer(static_cast<int>(count));
  auto chosen = waiting.begin();
  while ((attended && !is_attended(*chosen)) || skip-- > 0) ++chosen;
  Hearing::Words words = std::move(*chosen);
  waiting.erase(chosen);
  return words;
}

int direction_to(const Player& listener, const Player& speaker) {
  return truncated_degrees(math::normalize_radians(
      soccer::direction_radians(speaker.position - listener.position) - listener.body));
}

soccer::Hear heard(const World& world, const Player& listener, const Player& speaker) {
  soccer::Hear hear;
  hear.time = world.clock.time;
  hear.sender = speaker.side == listener.side ? soccer::Hear::Sender::kTeammate
                                              : soccer::Hear::Sender::kOpponent;
  hear.unum = speaker.unum;
  return hear;
}

void hear_trainer(const World& world, std::vector<std::string>& waiting,
                  std::vector<soccer::Hear>& out) {
  for (std::string& words : waiting) {
    soccer::Hear& hear = out.emplace_back();
    hear.time = world.clock.time;
    hear.sender = soccer::Hear::Sender::kTrainer;
    hear.text = std::move(words);
  }
  waiting.clear();
}

void hear_own_words(const World& world, Slot listener, std::vector<Hearing::Words>& waiting,
                    std::vector<soccer::Hear>& out) {
  for (Hearing::Words& words : waiting) {
    if (words.speaker != listener) continue;
    soccer::Hear& own = out.emplace_back();
    own.time = world.clock.time;
    own.sender = soccer::Hear::Sender::kSelf;
    own.text = std::move(words.text);
  }
  const auto is_own = [&](const Hearing::Words& words) { return words.speaker == listener; };
  waiting.erase(std::remove_if(waiting.begin(), waiting.end(), is_own), waiting.end());
}

}  // namespace

void overhear(const World& world, const PlayerSaid& said, Slot listener, Hearing& hearing) {
  const Player& player = world.player(listener);
  if (!player.enabled) return;
  if (listener != said.speaker) {
    const double reach = world.params().audio_cut_dist;
    if (soccer::distance(player.position, said.position) > reach) return;
    const std::size_t side = index(soccer::side_of_slot(said.speaker));
    if (!player.ears.complete[side] && !player.ears.partial[side]) return;
  }
  const auto of_speaker = [&](const Hearing::Words& words) {
    return words.speaker == said.speaker;
  };
  if (std::count_if(hearing.waiting.begin(), hearing.waiting.end(), of_speaker) <
      Hearing::kMostOfOneSpeaker) {
    hearing.waiting.push_back({said.speaker, said.text});
  }
}

void hear(World& world, Slot slot, Hearing& hearing, RandomStream& choice,
          std::vector<soccer::Hear>& out) {
  hear_trainer(world, hearing.of_trainer, out);
  hear_own_words(world, slot, hearing.waiting, out);
  Player& listener = world.player(slot);
  const int cost = world.params().hear_decay;
  while (!hearing.waiting.empty()) {
    Hearing::Words words = take_next(listener, hearing.waiting, choice);
    const Player& speaker = world.player(words.speaker);
    const std::size_t side = index(speaker.side);
    int& capacity = speaker.side == listener.side ? listener.ears.teammate_capacity
                                                  : listener.ears.opponent_capacity;
    if (capacity >= cost) {
      if (!listener.ears.complete[side]) continue;
      capacity -= cost;
      out.push_back(heard(world, listener, speaker));
      out.back().direction = direction_to(listener, speaker);
      out.back().text = std::move(words.text);
    } else if (listener.ears.partial[side]) {
      out.push_back(heard(world, listener, speaker));
      out.back().partial = true;
    }
  }
}

}  // namespace cls::simulator
