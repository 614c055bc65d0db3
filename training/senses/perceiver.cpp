// Messages from the simulator to the world model of the agents.
#include "training/senses/perceiver.h"

#include <cassert>
#include <utility>
#include <variant>

#include "player/looking/looking.h"
#include "player/perception/partial_update.h"
#include "player/perception/perception.h"
#include "simulator/senses/body_sense.h"
#include "simulator/sessions/connection.h"
#include "soccer/memory_channel.h"
#include "soccer/messages/values.h"

namespace cls::training {
namespace {

// Messages that the server has formatted parse.
template <typename Message>
void read(std::string_view text, Message& out) {
  const base::Result<void> parsed = parse(text, out);
  assert(parsed);
}

void hear(const soccer::Hear& message, Perceiver& agent, SenseBuffers& buffers) {
  buffers.text.clear();
  format(message, soccer::Recipient::kPlayer, buffers.text);
  read(buffers.text, buffers.hear);
  on_hear(agent.world, buffers.hear);
}

void hear_referee(const simulator::Events& events, Perceiver& agent, SenseBuffers& buffers) {
  for (const simulator::Event& event : events) {
    const auto* message = std::get_if<simulator::RefereeMessage>(&event.what);
    if (message == nullptr) continue;
    soccer::Hear heard;
    heard.time = event.clock.time;
    message->append_to(heard.text);
    hear(heard, agent, buffers);
  }
}

void hear_players(simulator::World& world, simulator::Slot slot, Perceiver& agent,
                  SenseBuffers& buffers) {
  if (agent.said.says.empty()) return;
  simulator::RandomStream choice = simulator::clock_stream(world, "hear", slot);
  buffers.heard.clear();
  simulator::hear(world, slot, agent.said, choice, buffers.heard);
  for (const soccer::Hear& message : buffers.heard) hear(message, agent, buffers);
}

void sense(const simulator::World& world, simulator::Slot slot, Perceiver& agent,
           SenseBuffers& buffers) {
  const int version = world.player(slot).client_version;
  buffers.sense_body = sense_body(world, slot);
  if (!make_as_sent(buffers.sense_body, version)) {
    buffers.text.clear();
    format(buffers.sense_body, version, buffers.text);
    read(buffers.text, buffers.sense_body);
  }
  on_sense_body(agent.world, buffers.sense_body);
}

void look(const simulator::VisionModel& vision, const simulator::World& world, simulator::Slot slot,
          Perceiver& agent, SenseBuffers& buffers) {
  simulator::RandomStream noise = simulator::clock_stream(world, "see", slot);
  see(vision, world, slot, noise, buffers.see);
  if (!make_as_sent(buffers.see)) {
    buffers.text.clear();
    format(buffers.see, buffers.text);
    read(buffers.text, buffers.see);
  }
  on_see(agent.world, buffers.see);
  agent.see_rounds = 0;
}

void complete(Perceiver& agent) {
  if (agent.decides) {
    update_derived(agent.world);
  } else {
    update_derived_for_looking(agent.world);
  }
}

void read_changed_types(const simulator::World& world, Perceiver& agent) {
  for (const simulator::Player& player : world.players) {
    if (player.type == 0) continue;
    soccer::PlayerTypeChange change{player.unum, std::nullopt};
    if (player.side == agent.world.our_side) change.type = player.type;
    on_change_player_type(agent.world, change);
  }
}

}  // namespace

Perceiver make_perceiver(const simulator::World& world, simulator::Slot slot) {
  const simulator::Player& player = world.player(slot);
  Perceiver agent;
  on_init(agent.world, {player.side, player.unum, world.mode}, world.team(player.side).name,
          player.goalie);

  auto [server_end, agent_end] = soccer::make_memory_channel();
  simulator::Connection connection;
  connection.version = player.client_version;
  connection.channel = std::move(server_end);
  send_parameters(world, connection);

  std::string message;
  while (agent_end->receive(message)) {
    const base::Result<void> parsed = on_parameter_message(agent.world, message);
    assert(parsed);
  }
  return agent;
}

void begin_perception(const simulator::VisionModel& vision, const simulator::World& world,
                      const simulator::Events& events, simulator::Slot slot, Perceiver& agent,
                      SenseBuffers& buffers) {
  read_changed_types(world, agent);
  hear_referee(events, agent, buffers);
  sense(world, slot, agent, buffers);
  look(vision, world, slot, agent, buffers);
  complete(agent);
}

void perceive(const simulator::VisionModel& vision, simulator::World& world,
              const simulator::Events& events, simulator::Slot slot, Perceiver& agent,
              SenseBuffers& buffers) {
  hear_referee(events, agent, buffers);
  const simulator::Player& player = world.player(slot);
  if (!player.enabled) return;
  sense(world, slot, agent, buffers);
  hear_players(world, slot, agent, buffers);
  update_heard_symbol(agent.world, agent.heard);
  if (++agent.see_rounds >= view_interval(player.view)) {
    look(vision, world, slot, agent, buffers);
  }
  complete(agent);
}

bool choose_commands(Perceiver& agent, const soccer::PlayerCommand& body) {
  update_view_memory(agent.view, agent.world);
  player::CommandSlots slots(agent.world);
  const bool accepted = set_body_command(agent.world, body, slots);
  choose_senses(agent.chosen, agent.world, agent.view, slots);
  slots.compose(agent.commands);
  record_sent_commands(agent.world, agent.commands);
  return accepted;
}

}  // namespace cls::training
