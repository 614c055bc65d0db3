// Packets for soccerwindow2's debug server.
#include "proxy/agent/debug_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "proto/playmaker.pb.h"
#include "proxy/agent/debug_options.h"
#include "tests/support/debug_packet.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using testing::ElementsAre;
using testing::SizeIs;
using tests::DebugPacket;
using tests::KnownPitch;

constexpr std::uint32_t kAllLevels = std::numeric_limits<std::uint32_t>::max();

std::string packet(const KnownPitch& pitch, const protos::PlayerActions* reply = nullptr,
                   std::string_view sent = {}, std::uint32_t levels = kAllLevels) {
  std::string text;
  format_debug_view(pitch.world, sent, reply, levels, text);
  return text;
}

DebugPacket parsed(const std::string& text) {
  DebugPacket read = tests::parse_debug_packet(text);
  EXPECT_EQ(read.error, "") << text;
  return read;
}

TEST(DebugView, HasWhatThePlayerEstimates) {
  KnownPitch pitch;
  pitch.place_self({10.5, -3.25}, 90.0);
  pitch.place_ball({12.0, -3.0}, {0.5, -0.25});
  pitch.add_teammate(9, {20.0, 5.0}, 45.0);
  pitch.add_opponent(3, {30.0, -5.0}, 180.0);
  const DebugPacket read = parsed(packet(pitch));

  EXPECT_EQ(read.cycle, 100);
  EXPECT_EQ(read.side, 'l');
  EXPECT_EQ(read.unum, 7);
  EXPECT_THAT(read.items.at("s"),
              ElementsAre(testing::StartsWith("(s l 7 0 10.5 -3.25 0 0 90 0 (c")));
  EXPECT_THAT(read.items.at("b"),
              ElementsAre(testing::StartsWith("(b 12 -3 0.5 -0.25 (c \"g0r0v0")));
  EXPECT_THAT(read.items.at("t"), ElementsAre(testing::StartsWith("(t 9 0 20 5 (bd 45) (c \"")));
  EXPECT_THAT(read.items.at("o"), ElementsAre(testing::StartsWith("(o 3 0 30 -5 (bd ")));
}

TEST(DebugView, HasTextsAndShapesOfThePlaymaker) {
  const KnownPitch pitch;
  protos::PlayerActions reply;
  reply.add_actions()->mutable_debug_client()->set_message("say \"hi\"\nnow");
  auto& text = *reply.add_actions()->mutable_log()->mutable_add_text();
  text.set_level(protos::PASS);
  text.set_message("to 9");
  auto& line = *reply.add_actions()->mutable_log()->mutable_add_line();
  line.mutable_end()->set_x(52.5F);
  line.set_color("red");
  auto& circle = *reply.add_actions()->mutable_log()->mutable_add_circle();
  circle.set_radius(2.5F);
  auto& rectangle = *reply.add_actions()->mutable_log()->mutable_add_rectangle();
  rectangle.set_left(1.0F);
  rectangle.set_length(2.0F);
  rectangle.set_width(3.0F);
  reply.add_actions()->mutable_log()->mutable_add_triangle();
  const DebugPacket read = parsed(packet(pitch, &reply, "(turn 1)(say \"ab1\")(done)"));

  EXPECT_THAT(read.items.at("message"), ElementsAre("(message \"say 'hi' now|to 9|\")"));
  EXPECT_THAT(read.items.at("line"), ElementsAre("(line 0 0 52.5 0 \"red\")"));
  EXPECT_THAT(read.items.at("circle"), ElementsAre("(circle 0 0 2.5)"));
  EXPECT_THAT(read.items.at("rect"), ElementsAre("(rect 1 0 3 3)"));
  EXPECT_THAT(read.items.at("tri"), SizeIs(1));
  EXPECT_THAT(read.items.at("say"), ElementsAre("(say \"{ab1}\")"));
}

TEST(DebugView, HasChosenLevelsOnly) {
  const KnownPitch pitch;
  protos::PlayerActions reply;
  reply.add_actions()->mutable_debug_client()->set_message("always");
  for (const auto level : {protos::PASS, protos::SHOOT}) {
    auto& text = *reply.add_actions()->mutable_log()->mutable_add_text();
    text.set_level(level);
    text.set_message(protos::LoggerLevel_Name(level));
  }
  const DebugPacket read = parsed(packet(pitch, &reply, {}, protos::SHOOT));
  EXPECT_THAT(read.items.at("message"), ElementsAre("(message \"always|SHOOT|\")"));
}

// Whatever a Playmaker sends, soccerwindow2 reads the packet.
TEST(DebugView, StaysReadableWithAnyReply) {
  const KnownPitch pitch;
  protos::PlayerActions reply;
  reply.add_actions()->mutable_debug_client()->set_message(std::string(20'000, 'x'));
  auto& infinite = *reply.add_actions()->mutable_log()->mutable_add_circle();
  infinite.set_radius(std::numeric_limits<float>::infinity());

  for (int i = 0; i < 2000; ++i) {
    auto& line = *reply.add_actions()->mutable_log()->mutable_add_line();
    line.mutable_start()->set_x(1e30F);
    line.set_color("\") (message \"no");
  }
  const std::string text = packet(pitch, &reply);
  EXPECT_LT(text.size(), kMaxDebugPacket);

  const DebugPacket read = parsed(text);
  EXPECT_FALSE(read.items.contains("circle"));
  EXPECT_GT(read.items.at("line").size(), 10U);
  EXPECT_THAT(read.items.at("message"), SizeIs(1));
}

TEST(DebugOptions, ReadsTheServer) {
  DebugOptions options;
  ASSERT_TRUE(set_debug_server(options, "127.0.0.1"));
  EXPECT_EQ(options.server_address->port(), kDebugServerPort);
  ASSERT_TRUE(set_debug_server(options, "127.0.0.1:7000"));
  EXPECT_EQ(options.server_address->port(), 7000);
  ASSERT_TRUE(set_debug_server(options, "[::1]:7000"));
  EXPECT_EQ(options.server_address->family(), AF_INET6);

  for (const char* wrong : {"127.0.0.1:", "127.0.0.1:0", "127.0.0.1:x", "127.0.0.1:70000"}) {
    const auto refused = set_debug_server(options, wrong);
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().message,
              "debug-server '" + std::string(wrong) + "': must be HOST:PORT");
  }
}

}  // namespace
}  // namespace cls::proxy
