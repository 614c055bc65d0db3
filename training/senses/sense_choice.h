// What agents may choose for their senses beside the command of the body: where they look and what
// they say.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "player/commands/command_slots.h"
#include "player/world/view_cone.h"
#include "player/world/world_model.h"

namespace cls::training {

/// Which choices the agents have; none by default.
struct SenseOptions {
  bool look = false;  ///< neck, view and focus
  bool say = false;   ///< a symbol that teammates hear

  bool any() const { return look || say; }
};

/// A choice of each cycle, by number. Number 0 is what agents without it do.
struct SenseHead {
  std::string_view name;
  std::vector<std::string_view> items;
};

/// In the order of the numbers that read_senses() takes.
std::vector<SenseHead> sense_heads(const SenseOptions& options);

/// Numbers of the items of each head.
struct SenseChoice {
  int neck = 0;
  int view = 0;
  int focus = 0;
  int say = 0;
};

/// `numbers` has one for each of sense_heads(), and they exist.
SenseChoice read_senses(const SenseOptions& options, const std::int32_t* numbers);

/// Sets neck, view, focus and say. Call it after the body command is set and after
/// update_view_memory().
void choose_senses(const SenseChoice& choice, const player::WorldModel& world,
                   const player::ViewMemory& view, player::CommandSlots& slots);

/// How many symbols there are; they have the numbers 1 to kSymbols.
constexpr int kSymbols = 8;

/// The last symbol that an agent has heard from a teammate.
struct HeardSymbol {
  int symbol = 0;              ///< 0: none yet
  int unum = 0;                ///< of the speaker
  int age = 0;                 ///< cycles
  player::AngleDeg direction;  ///< global, to the speaker
};

/// Call it once a cycle, when the messages of the cycle have been read.
void update_heard_symbol(const player::WorldModel& world, HeardSymbol& heard);

}  // namespace cls::training
