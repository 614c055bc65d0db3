// Parameter messages compared with recorded messages of upstream's proxy.
#include "proxy/messages/parameter_messages.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "soccer/messages/parameter_message.h"
#include "soccer/protocol/message_kind.h"
#include "tests/support/files.h"
#include "tests/support/message_stream.h"
#include "tests/support/transcript.h"

namespace cls::proxy {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

/// Server messages to agent 7 of the recorded match, whose RPCs are in fixtures/grpc.
struct Announced {
  soccer::ServerParams server;
  soccer::PlayerParams player;
  std::vector<soccer::PlayerType> types;
};

std::vector<std::string> recorded(const std::string& method) {
  return tests::split_messages(tests::read_file(tests::fixture("grpc/" + method + ".req.pb.gz")));
}

void read_announcement(std::string_view message, Announced& announced) {
  switch (soccer::message_kind(message)) {
    case soccer::MessageKind::kServerParam:
      ASSERT_TRUE(soccer::parse(message, announced.server));
      break;
    case soccer::MessageKind::kPlayerParam:
      ASSERT_TRUE(soccer::parse(message, announced.player));
      break;
    case soccer::MessageKind::kPlayerType:
      ASSERT_TRUE(soccer::parse(message, announced.types.emplace_back()));
      break;
    default:
      break;
  }
}

Announced read_announcements(const std::string& transcript) {
  Announced announced;
  for (const tests::Spoken& spoken : tests::read_transcript(transcript)) {
    if (spoken.by_server) read_announcement(spoken.message, announced);
  }
  return announced;
}

/// Compares every field; numbers may differ by rounding of the last place of a float.
void expect_same_fields(const Message& ours, const Message& theirs) {
  const Reflection& reflection = *ours.GetReflection();
  for (int i = 0; i < ours.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *ours.GetDescriptor()->field(i);
    SCOPED_TRACE(field.name());

    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_FLOAT:
        EXPECT_FLOAT_EQ(reflection.GetFloat(ours, &field), reflection.GetFloat(theirs, &field));
        break;
      case FieldDescriptor::CPPTYPE_INT32:
        EXPECT_EQ(reflection.GetInt32(ours, &field), reflection.GetInt32(theirs, &field));
        break;
      case FieldDescriptor::CPPTYPE_BOOL:
        EXPECT_EQ(reflection.GetBool(ours, &field), reflection.GetBool(theirs, &field));
        break;
      case FieldDescriptor::CPPTYPE_STRING:
        EXPECT_EQ(reflection.GetString(ours, &field), reflection.GetString(theirs, &field));
        break;
      case FieldDescriptor::CPPTYPE_MESSAGE:
        EXPECT_EQ(field.name(), "register_response");
        break;
      default:
        ADD_FAILURE() << "a field of an unexpected type";
    }
  }
}

template <typename Params>
Params with_every_value_set(const soccer::ParameterTable<Params>& table) {
  Params params;
  for (const auto& row : table) {
    std::visit(
        [&](auto member) {
          using Value = std::remove_reference_t<decltype(params.*member)>;
          if constexpr (std::is_same_v<Value, std::string>) {
            params.*member = "text";
          } else if constexpr (std::is_same_v<Value, bool>) {
            params.*member = true;
          } else {
            params.*member = 1;
          }
        },
        row.member);
  }

  return params;
}

std::set<std::string> unset_fields(const Message& message) {
  std::set<std::string> unset;
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    if (!message.GetReflection()->HasField(message, &field)) unset.insert(field.name());
  }
  return unset;
}

TEST(ParameterMessages, EqualThoseOfUpstreamProxy) {
  const auto transcript = tests::data("aligned/udp/player_l7.txt.gz");
  if (!transcript) GTEST_SKIP() << "no data: set CLS_DATA";
  const Announced announced = read_announcements(tests::read_file(*transcript));

  protos::ServerParam server;
  protos::ServerParam rcssserver_program;
  fill(announced.server, server);
  ASSERT_TRUE(rcssserver_program.ParseFromString(recorded("SendServerParams").at(0)));
  expect_same_fields(server, rcssserver_program);

  protos::PlayerParam player;
  protos::PlayerParam real_player;
  fill(announced.player, player);
  ASSERT_TRUE(real_player.ParseFromString(recorded("SendPlayerParams").at(0)));
  expect_same_fields(player, real_player);

  const std::vector<std::string> real_types = recorded("SendPlayerType");
  ASSERT_EQ(announced.types.size(), 18U);
  ASSERT_EQ(real_types.size(), 18U);
  for (std::size_t i = 0; i < real_types.size(); ++i) {
    SCOPED_TRACE(i);
    protos::PlayerType type;
    protos::PlayerType real_type;
    fill(announced.types[i], announced.server, type);
    ASSERT_TRUE(real_type.ParseFromString(real_types[i]));
    expect_same_fields(type, real_type);
  }
}

TEST(ParameterMessages, MatchUpstreamForDefaults) {
  protos::ServerParam ours;
  protos::ServerParam real;
  soccer::ServerParams params;
  // Settings of the recorded match.
  params.synch_mode = true;
  params.auto_mode = true;
  params.half_time = 30;
  params.nr_extra_halfs = 0;
  params.penalty_shoot_outs = false;
  params.connect_wait = 1000000;
  params.port = 28000;
  params.coach_port = 28001;
  params.olcoach_port = 28002;
  fill(params, ours);

  ASSERT_TRUE(real.ParseFromString(recorded("SendServerParams").at(0)));
  expect_same_fields(ours, real);
}

TEST(ParameterMessages, SetEveryFieldExceptTexts) {
  protos::ServerParam server;
  protos::PlayerParam player;
  protos::PlayerType type;
  const auto server_params = with_every_value_set(soccer::server_param_table());
  auto player_type = with_every_value_set(soccer::player_type_table());
  player_type.player_decay = 0.5;
  fill(server_params, server);
  fill(with_every_value_set(soccer::player_param_table()), player);
  fill(player_type, server_params, type);

  const std::set<std::string> texts = {"replay_file",
                                       "landmark_file",
                                       "text_log_dir",
                                       "game_log_dir",
                                       "text_log_fixed_name",
                                       "game_log_fixed_name",
                                       "log_date_format",
                                       "team_l_start",
                                       "team_r_start",
                                       "keepaway_log_dir",
                                       "keepaway_log_fixed_name",
                                       "module_dir",
                                       "coach_msg_file",
                                       "fixed_teamname_l",
                                       "fixed_teamname_r",
                                       "control_radius_width"};  // radius 1 less player size 1

  EXPECT_EQ(unset_fields(server), texts);
  EXPECT_EQ(unset_fields(player), std::set<std::string>{});
  EXPECT_EQ(unset_fields(type), std::set<std::string>{});
}

TEST(ParameterMessages, KeepIdentityAndClearOtherFields) {
  protos::PlayerType message;
  message.mutable_register_response()->set_client_id(7);
  message.set_id(5);
  fill(soccer::default_player_type({}), {}, message);
  EXPECT_EQ(message.register_response().client_id(), 7);
  EXPECT_EQ(message.id(), 0);
}

}  // namespace
}  // namespace cls::proxy
