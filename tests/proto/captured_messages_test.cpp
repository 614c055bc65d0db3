// Messages of a match with the upstream proxy: all fields are known, and all bytes round-trip.
#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/message.h>
#include <google/protobuf/unknown_field_set.h>
#include <google/protobuf/wire_format_lite.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "proto/playmaker.pb.h"
#include "tests/support/files.h"
#include "tests/support/message_stream.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;
namespace pb = google::protobuf;

/// Lists all fields and enum values in `message` that the interface does not define.
void list_unknown(const pb::Message& message, std::vector<std::string>& found) {
  const pb::Reflection& reflection = *message.GetReflection();
  const pb::UnknownFieldSet& unknown = reflection.GetUnknownFields(message);

  for (int i = 0; i < unknown.field_count(); ++i) {
    found.push_back(message.GetTypeName() + " " + std::to_string(unknown.field(i).number()));
  }

  std::vector<const pb::FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);

  for (const pb::FieldDescriptor* field : fields) {
    if (field->cpp_type() == pb::FieldDescriptor::CPPTYPE_ENUM) {
      const int number = reflection.GetEnumValue(message, field);
      if (field->enum_type()->FindValueByNumber(number) == nullptr) {
        found.push_back(field->full_name() + " = " + std::to_string(number));
      }
    }
    if (field->cpp_type() != pb::FieldDescriptor::CPPTYPE_MESSAGE) continue;
    if (!field->is_repeated()) {
      list_unknown(reflection.GetMessage(message, field), found);
      continue;
    }
    for (int i = 0; i < reflection.FieldSize(message, field); ++i) {
      list_unknown(reflection.GetRepeatedMessage(message, field, i), found);
    }
  }
}

std::string varint(std::uint32_t value) {
  std::string bytes;
  pb::io::StringOutputStream out(&bytes);
  pb::io::CodedOutputStream(&out).WriteVarint32(value);
  return bytes;
}

/// One field in wire format.
struct Piece {
  const pb::FieldDescriptor* field;
  std::int32_t map_key;  // 0 unless the field is a map
  std::string bytes;
};

std::int32_t map_key_of(const std::string& entry) {
  pb::io::CodedInputStream in(reinterpret_cast<const std::uint8_t*>(entry.data()),
                              static_cast<int>(entry.size()));
  std::uint64_t key = 0;
  if (in.ReadTag() != 8 || !in.ReadVarint64(&key)) throw std::runtime_error("map without key");
  return static_cast<std::int32_t>(key);
}

std::string with_sorted_maps(const std::string& bytes, const pb::Descriptor& type);

Piece read_piece(pb::io::CodedInputStream& in, const pb::Descriptor& type) {
  using pb::internal::WireFormatLite;
  const std::uint32_t tag = in.ReadTag();
  Piece piece{type.FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag)), 0, varint(tag)};
  if (piece.field == nullptr) throw std::runtime_error("unknown field in " + type.name());
  std::string body;
  std::uint64_t number = 0;
  std::uint32_t length = 0;

  switch (WireFormatLite::GetTagWireType(tag)) {
    case WireFormatLite::WIRETYPE_VARINT: {
      const int start = in.CurrentPosition();
      if (!in.ReadVarint64(&number)) throw std::runtime_error("bad varint");
      const int size = in.CurrentPosition() - start;
      pb::io::StringOutputStream out(&body);
      pb::io::CodedOutputStream(&out).WriteVarint64(number);
      if (static_cast<int>(body.size()) != size) throw std::runtime_error("padded varint");
      break;
    }
    case WireFormatLite::WIRETYPE_FIXED32:
      in.ReadString(&body, 4);
      break;
    case WireFormatLite::WIRETYPE_FIXED64:
      in.ReadString(&body, 8);
      break;
    case WireFormatLite::WIRETYPE_LENGTH_DELIMITED:
      if (!in.ReadVarint32(&length) || !in.ReadString(&body, static_cast<int>(length))) {
        throw std::runtime_error("bad length");
      }
      if (piece.field->is_map()) piece.map_key = map_key_of(body);
      if (piece.field->message_type() != nullptr) {
        body = with_sorted_maps(body, *piece.field->message_type());
      }
      body = varint(length) + body;
      break;
    default:
      throw std::runtime_error("unexpected wire type");
  }

  piece.bytes += body;
  return piece;
}

/// `bytes` with the entries of each map sorted by key, because their order depends on the sender.
std::string with_sorted_maps(const std::string& bytes, const pb::Descriptor& type) {
  pb::io::CodedInputStream in(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                              static_cast<int>(bytes.size()));
  std::vector<Piece> pieces;

  while (in.CurrentPosition() < static_cast<int>(bytes.size())) {
    pieces.push_back(read_piece(in, type));
  }

  for (auto first = pieces.begin(); first != pieces.end();) {
    const auto last = std::find_if(first, pieces.end(),
                                   [&](const Piece& piece) { return piece.field != first->field; });
    std::stable_sort(first, last,
                     [](const Piece& a, const Piece& b) { return a.map_key < b.map_key; });
    first = last;
  }
  std::string sorted;
  for (const Piece& piece : pieces) sorted += piece.bytes;
  return sorted;
}

std::string written(const pb::Message& message) {
  std::string bytes;
  pb::io::StringOutputStream out(&bytes);
  pb::io::CodedOutputStream coded(&out);
  coded.SetSerializationDeterministic(true);
  message.SerializeToCodedStream(&coded);
  coded.Trim();
  return bytes;
}

/// The message in `file`; its name ends with METHOD.req.pb.gz or METHOD.rsp.pb.gz.
const pb::Descriptor& type_in(const fs::path& file) {
  const std::string stem = file.stem().stem().stem().string();  // [AGENT.]METHOD
  const bool reply = file.stem().stem().extension() == ".rsp";
  const std::string method = stem.substr(stem.find_last_of('.') + 1);
  const pb::MethodDescriptor* found =
      protos::Empty::descriptor()->file()->FindServiceByName("Game")->FindMethodByName(method);
  if (found == nullptr) throw std::runtime_error("no such method: " + file.string());
  return reply ? *found->output_type() : *found->input_type();
}

/// Checks all messages of the file; returns their number.
std::size_t check_file(const fs::path& file) {
  const pb::Descriptor& type = type_in(file);
  const std::vector<std::string> messages = split_messages(read_file(file));

  for (std::size_t i = 0; i < messages.size(); ++i) {
    SCOPED_TRACE(file.filename().string() + " message " + std::to_string(i));
    const std::unique_ptr<pb::Message> message(
        pb::MessageFactory::generated_factory()->GetPrototype(&type)->New());
    EXPECT_TRUE(message->ParseFromString(messages[i]));
    std::vector<std::string> unknown;
    list_unknown(*message, unknown);
    EXPECT_EQ(unknown, std::vector<std::string>{});
    EXPECT_TRUE(written(*message) == with_sorted_maps(messages[i], type)) << "bytes differ";
    if (::testing::Test::HasFailure()) break;
  }

  return messages.size();
}

std::size_t check_folder(const fs::path& folder) {
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().ends_with(".pb.gz")) count += check_file(entry.path());
  }
  return count;
}

template <typename Message>
std::vector<Message> parsed(const std::string& name) {
  std::vector<Message> messages;
  for (const std::string& bytes : split_messages(read_file(fixture("grpc/" + name)))) {
    if (!messages.emplace_back().ParseFromString(bytes)) throw std::runtime_error(name);
  }
  return messages;
}

TEST(CapturedMessages, AreKnownAndRoundTrip) {
  EXPECT_EQ(check_folder(fixture("grpc")), 5u * 6 + 4 + 36 + 8 + 4 + 7 + 1);
}

TEST(CapturedMessages, OfWholeMatchAreKnownAndRoundTrip) {
  const auto folder = data("aligned/grpc");
  if (!folder) GTEST_SKIP() << "no data: set CLS_DATA";
  const std::string index = read_file(*folder / "index.tsv.gz");  // a heading and a line per call
  const auto calls = std::count(index.begin(), index.end(), '\n') - 1;
  ASSERT_GT(calls, 4000);
  EXPECT_EQ(check_folder(*folder), 2 * static_cast<std::size_t>(calls));
}

TEST(CapturedMessages, ReportUnknownFieldsAndEnumValues) {
  protos::State state;  // field 99 of the first teammate
  ASSERT_TRUE(state.ParseFromString("\x12\x05\x42\x03\x98\x06\x01"));

  protos::RegisterRequest request;  // agent_type 9
  ASSERT_TRUE(request.ParseFromString("\x08\x09"));
  std::vector<std::string> unknown;
  list_unknown(state, unknown);
  list_unknown(request, unknown);
  EXPECT_EQ(unknown, (std::vector<std::string>{"protos.Player 99",
                                               "protos.RegisterRequest.agent_type = 9"}));
}

TEST(CapturedMessages, AreComparedWithSortedMaps) {
  const pb::Descriptor& type = *protos::WorldModel::descriptor();
  const std::string two("\xfa\x01\x04\x08\x02\x12\x00", 7);  // helios_home_positions 2: empty
  const std::string one("\xfa\x01\x04\x08\x01\x12\x00", 7);  // and 1
  const std::string cycle("\xa8\x01\x07", 3);
  EXPECT_EQ(with_sorted_maps(cycle + two + one, type), cycle + one + two);
  EXPECT_EQ(with_sorted_maps(two + cycle + one, type), two + cycle + one);
}

TEST(CapturedMessages, RegisterAgents) {
  const auto request = parsed<protos::RegisterRequest>("Register.req.pb.gz").at(4);
  EXPECT_EQ(request.agent_type(), protos::CoachT);
  EXPECT_EQ(request.team_name(), "PROXY");
  EXPECT_EQ(request.uniform_number(), 12);
  const auto reply = parsed<protos::RegisterResponse>("Register.rsp.pb.gz").at(2);
  EXPECT_EQ(reply.client_id(), 8);
  EXPECT_EQ(reply.agent_type(), protos::PlayerT);
  EXPECT_EQ(reply.uniform_number(), 7);
}

TEST(CapturedMessages, ContainServerParameters) {
  const auto server = parsed<protos::ServerParam>("SendServerParams.req.pb.gz").at(0);

  EXPECT_EQ(server.register_response().client_id(), 8);
  EXPECT_FLOAT_EQ(server.player_decay(), 0.4f);
  EXPECT_FLOAT_EQ(server.ball_decay(), 0.94f);
  EXPECT_FLOAT_EQ(server.visible_angle(), 90);
  EXPECT_FLOAT_EQ(server.catch_area_l(), 1.2f);
  EXPECT_EQ(server.half_time(), 30);  // seconds: the match had halves of 300 cycles
  EXPECT_EQ(server.game_log_version(), 6);
  EXPECT_TRUE(server.synch_mode());
  EXPECT_FALSE(server.keepaway_mode());
  EXPECT_FLOAT_EQ(server.tackle_width(), 1.25f);
  EXPECT_FLOAT_EQ(server.stamina_capacity(), 130600);
  EXPECT_EQ(server.max_monitors(), -1);
  EXPECT_FLOAT_EQ(server.goal_width(), 14.02f);
  EXPECT_FLOAT_EQ(server.pitch_margin(), 5);

  const auto player = parsed<protos::PlayerParam>("SendPlayerParams.req.pb.gz").at(0);
  EXPECT_EQ(player.player_types(), 18);
  EXPECT_FLOAT_EQ(player.new_dash_power_rate_delta_min(), -0.0012f);
  EXPECT_FLOAT_EQ(player.catchable_area_l_stretch_max(), 1.3f);

  const auto type = parsed<protos::PlayerType>("SendPlayerType.req.pb.gz").at(3);
  EXPECT_EQ(type.id(), 3);
  EXPECT_FLOAT_EQ(type.player_decay(), 0.416252f);
  EXPECT_FLOAT_EQ(type.kickable_area(), 1.18058205f);
  EXPECT_EQ(type.cycles_to_reach_max_speed(), 6);
  EXPECT_FLOAT_EQ(type.player_speed_max(), 1.05f);
}

TEST(CapturedMessages, ContainWorldModel) {
  const auto state = parsed<protos::State>("GetPlayerActions.req.pb.gz").at(2);

  EXPECT_EQ(state.register_response().uniform_number(), 4);
  EXPECT_FALSE(state.need_preprocess());

  const protos::WorldModel& world = state.world_model();
  EXPECT_EQ(world.our_team_name(), "PROXY");
  EXPECT_EQ(world.their_team_name(), "HELIOS_R");
  EXPECT_EQ(world.our_side(), protos::LEFT);
  EXPECT_EQ(world.cycle(), 255);
  EXPECT_EQ(world.game_mode_type(), protos::FoulCharge_);
  EXPECT_EQ(world.game_mode_side(), protos::RIGHT);
  EXPECT_EQ(world.intercept_table().second_teammate_reach_steps(), 10);
  EXPECT_FLOAT_EQ(world.self().stamina_capacity(), 118630);
  EXPECT_FLOAT_EQ(world.self().relative_neck_direction(), 89);
  EXPECT_FLOAT_EQ(world.self().get_safety_dash_power(), 100);
  EXPECT_TRUE(std::isinf(world.self().heard_position().x()));  // never heard
  EXPECT_FLOAT_EQ(world.ball().relative_position().x(), 9.97662354f);
  EXPECT_EQ(world.ball().heard_vel_count(), 18);
  ASSERT_EQ(world.teammates_size(), 9);
  EXPECT_EQ(world.teammates(0).uniform_number(), 7);
  EXPECT_EQ(world.teammates(0).type_id(), 9);
  EXPECT_FLOAT_EQ(world.our_players_dict().at(2).heard_position().x(), -9.03f);
  EXPECT_EQ(world.helios_home_positions_size(), 11);
}

TEST(CapturedMessages, ContainPlayerActions) {
  const auto replies = parsed<protos::PlayerActions>("GetPlayerActions.rsp.pb.gz");
  const protos::PlayerActions& reply = replies.at(3);
  ASSERT_EQ(reply.actions_size(), 2);
  EXPECT_EQ(reply.actions(0).action_case(), protos::PlayerAction::kHeliosShoot);
  ASSERT_EQ(reply.actions(1).action_case(), protos::PlayerAction::kHeliosOffensivePlanner);
  EXPECT_TRUE(reply.actions(1).helios_offensive_planner().through_pass());
  EXPECT_FALSE(reply.actions(1).helios_offensive_planner().server_side_decision());

  const auto coach = parsed<protos::CoachActions>("GetCoachActions.rsp.pb.gz").at(0);
  EXPECT_EQ(coach.actions(0).action_case(), protos::CoachAction::kDoHeliosSubstitute);
}

}  // namespace
}  // namespace cls::tests
