// Adding the entries of dictionaries that a lean State leaves out.
#include "proto/lean_state.h"

namespace cls::proto {
namespace {

using PlayerList = google::protobuf::RepeatedPtrField<protos::Player>;
using PlayerMap = google::protobuf::Map<google::protobuf::int32, protos::Player>;

void add_missing(const PlayerList& players, PlayerMap& dictionary) {
  for (const protos::Player& player : players) {
    if (player.uniform_number() < 1 || dictionary.contains(player.uniform_number())) continue;
    dictionary[player.uniform_number()] = player;
  }
}

}  // namespace

void complete(protos::State& state) {
  if (!state.has_world_model()) return;
  protos::WorldModel& world = *state.mutable_world_model();
  add_missing(world.teammates(), *world.mutable_our_players_dict());
  add_missing(world.opponents(), *world.mutable_their_players_dict());
}

}  // namespace cls::proto
