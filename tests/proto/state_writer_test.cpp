// StateWriter against the generated code of protobuf: the same bytes for every State.
#include "proto/state_writer.h"

#include <google/protobuf/stubs/logging.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "proto/sorted_maps.h"
#include "tests/proxy/playmaker/random_message.h"
#include "tests/support/files.h"
#include "tests/support/message_stream.h"

namespace cls::proto {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

std::string generated(const protos::State& state) {
  std::string bytes;
  write_with_sorted_maps(state, bytes);
  return bytes;
}

std::string written(const protos::State& state) {
  StateWriter writer;
  return std::string(writer.write(state, StateForm::kWhole));
}

/// Sets every number of a message and of the messages in it to what takes the most bytes.
void widen(Message& message) {
  const auto& reflection = *message.GetReflection();

  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor* field = message.GetDescriptor()->field(i);
    if (field->is_repeated()) continue;
    switch (field->cpp_type()) {
      case FieldDescriptor::CPPTYPE_INT32:
        reflection.SetInt32(&message, field, -1);
        break;
      case FieldDescriptor::CPPTYPE_ENUM:
        reflection.SetEnumValue(&message, field, -1);
        break;
      case FieldDescriptor::CPPTYPE_FLOAT:
        reflection.SetFloat(&message, field, -0.0F);
        break;
      case FieldDescriptor::CPPTYPE_DOUBLE:
        reflection.SetDouble(&message, field, -0.0);
        break;
      case FieldDescriptor::CPPTYPE_BOOL:
        reflection.SetBool(&message, field, true);
        break;
      case FieldDescriptor::CPPTYPE_MESSAGE:
        widen(*reflection.MutableMessage(&message, field));
        break;
      default:
        break;
    }
  }
}

void widen_repeated(protos::WorldModel& world) {
  for (int number = -15; number < 15; ++number) {
    widen(*world.add_teammates());
    widen(*world.add_unknowns());
    widen((*world.mutable_our_players_dict())[number]);
    widen((*world.mutable_their_players_dict())[number]);
    widen((*world.mutable_helios_home_positions())[number]);
    widen(*world.mutable_intercept_table()->add_self_intercept_info());
  }
}

TEST(StateWriter, RecordedStatesHaveTheSameBytes) {
  const std::string stream = tests::read_file(tests::fixture("grpc/GetPlayerActions.req.pb.gz"));
  int states = 0;

  for (const std::string& message : tests::split_messages(stream)) {
    protos::State state;
    ASSERT_TRUE(state.ParseFromString(message));
    EXPECT_EQ(written(state), generated(state));
    ++states;
  }
  EXPECT_GT(states, 0);
}

TEST(StateWriter, RandomStatesHaveTheSameBytes) {
  const google::protobuf::LogSilencer silent;  // about texts that are not UTF-8
  tests::RandomMessages random(5);
  StateWriter reused;
  for (int i = 0; i < 3000; ++i) {
    protos::State state;
    random.fill(state);
    ASSERT_EQ(reused.write(state, StateForm::kWhole), generated(state)) << state.DebugString();
  }
}

TEST(StateWriter, WidestFieldsHaveTheSameBytes) {
  protos::State state;
  widen(state);
  widen_repeated(*state.mutable_world_model());
  widen_repeated(*state.mutable_full_world_model());
  EXPECT_EQ(written(state), generated(state));
}

TEST(StateWriter, EmptyMessagesHaveTheSameBytes) {
  protos::State state;
  EXPECT_EQ(written(state), "");

  protos::WorldModel& world = *state.mutable_world_model();
  EXPECT_EQ(written(state), generated(state));
  world.add_teammates()->mutable_position();
  world.mutable_intercept_table()->add_self_intercept_info();
  (*world.mutable_our_players_dict())[0];
  (*world.mutable_helios_home_positions())[0];
  EXPECT_EQ(written(state), generated(state));
}

TEST(StateWriter, WritesWhatIsKnownBesideFieldsOfLaterInterfaces) {
  protos::State state;
  widen(state);
  const std::string known = generated(state);
  const auto add_later_field = [](Message& message) {
    message.GetReflection()->MutableUnknownFields(&message)->AddLengthDelimited(
        1000, std::string(100'000, 'x'));
  };
  protos::WorldModel& world = *state.mutable_world_model();
  for (Message* message : std::initializer_list<Message*>{
           &state, &world, world.mutable_self(), world.mutable_ball(),
           world.mutable_penalty_kick_state(), world.mutable_intercept_table(),
           world.mutable_self()->mutable_position(), state.mutable_register_response()}) {
    add_later_field(*message);
  }

  protos::State read;
  ASSERT_TRUE(read.ParseFromString(written(state)));

  read.DiscardUnknownFields();
  EXPECT_EQ(generated(read), known);
}

TEST(StateWriter, LongAndShortMessagesFollowOneAnother) {
  protos::State large;
  widen_repeated(*large.mutable_world_model());
  protos::State small;
  small.mutable_world_model()->set_cycle(7);
  StateWriter writer;
  EXPECT_EQ(writer.write(large, StateForm::kWhole), generated(large));
  EXPECT_EQ(writer.write(small, StateForm::kWhole), generated(small));
  EXPECT_EQ(writer.write(large, StateForm::kWhole), generated(large));
}

}  // namespace
}  // namespace cls::proto
