// An agent that perceives the world through messages, as cls agents do in matches.
#pragma once

#include <string>
#include <vector>

#include "player/world/view_cone.h"
#include "player/world/world_model.h"
#include "simulator/senses/hearing.h"
#include "simulator/senses/vision.h"
#include "simulator/world/event.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "training/senses/sense_choice.h"

namespace cls::training {

/// A copyable value: world model and what the server remembers of the agent's senses.
struct Perceiver {
  player::WorldModel world;
  player::ViewMemory view;
  bool decides = true;  ///< by the skills of agents in matches; false: the caller of the pool does
  int see_rounds = 0;   ///< since the last see message
  simulator::PendingMessages said;              ///< by players, not heard yet
  std::vector<soccer::PlayerCommand> commands;  ///< of the current cycle
  SenseChoice chosen;                           ///< for the current cycle
  HeardSymbol heard;
};

/// Memory that is reused from message to message.
struct SenseBuffers {
  std::string text;
  soccer::SenseBody sense_body;
  soccer::See see;
  soccer::Hear hear;
  std::vector<soccer::Hear> heard;
};

/// A connected player in `slot` that has received parameters and player types.
Perceiver make_perceiver(const simulator::World& world, simulator::Slot slot);

/// The first messages of an episode: changed player types, referee messages among `events`,
/// sense_body and see.
void begin_perception(const simulator::VisionModel& vision, const simulator::World& world,
                      const simulator::Events& events, simulator::Slot slot, Perceiver& agent,
                      SenseBuffers& buffers);

/// The messages that MatchServer sends between a step and the decision: referee messages among
/// `events`, sense_body, what players said (agent.said), and see where one is due, with the numbers
/// and details of their text. Then completes the world model.
/// Uses up hearing capacity. Does not allocate after the first cycles.
void perceive(const simulator::VisionModel& vision, simulator::World& world,
              const simulator::Events& events, simulator::Slot slot, Perceiver& agent,
              SenseBuffers& buffers);

/// Completes a body command and what the agent has chosen for its senses to agent.commands; false
/// if the server would reject the body command.
bool choose_commands(Perceiver& agent, const soccer::PlayerCommand& body);

}  // namespace cls::training
