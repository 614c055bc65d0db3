// LEAN_STATES: what is left out, and that completing a State gives every byte back.
#include "proto/lean_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "proto/sorted_maps.h"
#include "proto/state_writer.h"
#include "tests/support/files.h"
#include "tests/support/message_stream.h"

namespace cls::proto {
namespace {

std::string whole(const protos::State& state) {
  std::string bytes;
  write_with_sorted_maps(state, bytes);
  return bytes;
}

protos::State lean(const protos::State& state) {
  StateWriter writer;
  const std::string bytes(writer.write(state, StateForm::kLean));
  protos::State parsed;
  EXPECT_TRUE(parsed.ParseFromString(bytes));
  EXPECT_EQ(whole(parsed), bytes) << "as if the State had been serialized without the entries";
  return parsed;
}

protos::Player& add_player(int number, protos::Player& player) {
  player.set_uniform_number(number);
  player.set_id(100 + number);
  player.mutable_position()->set_x(static_cast<float>(number) / 4);
  return player;
}

/// Teammates 2 and 3, opponent 5, the agent itself as 9, and a player of unknown number.
protos::State small_state() {
  protos::State state;
  state.mutable_register_response()->set_client_id(3);
  state.set_need_preprocess(true);
  protos::WorldModel& world = *state.mutable_world_model();
  world.set_cycle(77);
  auto& ours = *world.mutable_our_players_dict();

  auto& theirs = *world.mutable_their_players_dict();
  for (const int number : {2, 3}) ours[number] = add_player(number, *world.add_teammates());
  theirs[5] = add_player(5, *world.add_opponents());
  add_player(9, ours[9]);
  theirs[-1].set_pos_count(4);
  return state;
}

TEST(LeanState, LacksThePlayersOfTheLists) {
  const protos::State state = lean(small_state());
  const protos::WorldModel& world = state.world_model();

  EXPECT_EQ(world.teammates_size(), 2);
  EXPECT_EQ(world.opponents_size(), 1);
  EXPECT_EQ(world.our_players_dict_size(), 1);
  EXPECT_TRUE(world.our_players_dict().contains(9));
  EXPECT_EQ(world.their_players_dict_size(), 1);
  EXPECT_TRUE(world.their_players_dict().contains(-1));
  EXPECT_EQ(world.cycle(), 77);
}

TEST(LeanState, CompletesToTheSameBytes) {
  const protos::State state = small_state();
  protos::State completed = lean(state);
  complete(completed);
  EXPECT_EQ(whole(completed), whole(state));
  complete(completed);
  EXPECT_EQ(whole(completed), whole(state));
}

TEST(LeanState, KeepsAnEntryThatDiffersFromTheList) {
  protos::State state = small_state();
  (*state.mutable_world_model()->mutable_our_players_dict())[3].set_ghost_count(1);
  protos::State completed = lean(state);
  EXPECT_EQ(completed.world_model().our_players_dict().at(3).ghost_count(), 1);
  complete(completed);
  EXPECT_EQ(whole(completed), whole(state));
}

TEST(LeanState, StateWithoutPlayersStaysAsItIs) {
  protos::State state;
  EXPECT_EQ(whole(lean(state)), "");
  complete(state);
  EXPECT_FALSE(state.has_world_model());
}

TEST(LeanState, RecordedStatesComplete) {
  const std::string stream = tests::read_file(tests::fixture("grpc/GetPlayerActions.req.pb.gz"));

  for (const std::string& message : tests::split_messages(stream)) {
    protos::State state;
    ASSERT_TRUE(state.ParseFromString(message));
    // Recorded with another proxy: entries differ from the lists. Make them equal, as ours are.
    protos::WorldModel& world = *state.mutable_world_model();
    for (const protos::Player& player : world.teammates()) {
      (*world.mutable_our_players_dict())[player.uniform_number()] = player;
    }
    for (const protos::Player& player : world.opponents()) {
      (*world.mutable_their_players_dict())[player.uniform_number()] = player;
    }
    protos::State completed = lean(state);
    complete(completed);
    EXPECT_EQ(whole(completed), whole(state));
  }
}

}  // namespace
}  // namespace cls::proto
