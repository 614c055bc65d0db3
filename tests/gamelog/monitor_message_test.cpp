// Monitor messages compared with those that rcssserver 19 sent to six monitors in parallel.
#include "gamelog/rcg/monitor_message.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "base/index.h"
#include "base/text/number_text.h"
#include "base/text/split.h"
#include "gamelog/rcg/binary_format.h"
#include "soccer/messages/parameter_message.h"
#include "tests/support/files.h"

namespace cls::gamelog {
namespace {

using nlohmann::json;

/// Messages sent by rcssserver, by kind, index in the sequence and version. Binary messages are in
/// hexadecimal digits, without trailing NULs.
class RcssserverMessages {
 public:
  RcssserverMessages() {
    std::istringstream lines(tests::read_file(tests::fixture("protocol/monitors.txt.gz")));
    for (std::string line; std::getline(lines, line);) {
      const std::vector<std::string_view> fields = base::split(line, '\t');
      const std::size_t begin = base::index(fields.at(3).data() - line.data());
      messages_[std::string(fields[0])][*base::parse_int(fields[1])][*base::parse_int(fields[2])] =
          line.substr(begin);
    }
  }

  using ByVersion = std::map<int, std::string>;
  const std::map<int, ByVersion>& of(const std::string& kind) { return messages_[kind]; }

 private:
  std::map<std::string, std::map<int, ByVersion>> messages_;
};

std::string bytes_of(const std::string& digits, std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    bytes += static_cast<char>(std::strtol(digits.substr(i, 2).c_str(), nullptr, 16));
  }
  bytes.resize(size, '\0');
  return bytes;
}

soccer::Vec2 vector_of(const json& object, const char* x, const char* y) {
  return {object.at(x), object.at(y)};
}

// The numbers in the `(c ...)` of every player of a text show.
std::vector<std::vector<int>> counts_in(const std::string& show) {
  std::vector<std::vector<int>> players;
  for (std::size_t at = 0; (at = show.find("(c ", at)) != std::string::npos; ++at) {
    std::istringstream numbers(show.substr(at + 3, show.find(')', at) - at - 3));
    auto& counts = players.emplace_back();
    for (int number = 0; numbers >> number;) counts.push_back(number);
  }
  return players;
}

CommandCounts counts_of(const std::vector<int>& n) {
  return {n[0], n[1], n[2], n[3], n[4],  n[5],
          n[6], n[7], n[8], n[9], n[10], n.size() > 11 ? n[11] : 0};
}

PlayerFrame player_of(const json& player) {
  PlayerFrame frame;
  frame.state = player.at("state");
  frame.type = player.at("type");
  frame.position = vector_of(player, "x", "y");
  frame.velocity = vector_of(player, "vx", "vy");
  frame.body = player.at("body");
  frame.neck = player.at("neck");
  if (player.contains("px")) frame.pointing_at = vector_of(player, "px", "py");
  frame.high_quality = player.at("vq") == "h";
  frame.view_width = player.at("vw");
  frame.focus_distance = player.at("fdist");
  frame.focus_direction = player.at("fdir");
  frame.stamina = player.at("stamina");
  frame.effort = player.at("effort");
  frame.recovery = player.at("recovery");
  frame.capacity = player.at("capacity");

  if (player.contains("fside")) {
    frame.attention_side = player.at("fside") == "l" ? soccer::Side::kLeft : soccer::Side::kRight;
    frame.attention_unum = player.at("fnum");
  }

  return frame;
}

// nlohmann::json parses -0 as an integer, which loses the sign.
std::string with_real_zeros(std::string text) {
  for (std::size_t at = 0; (at = text.find(":-0,", at)) != std::string::npos;) {
    text.insert(at + 3, ".0");
  }
  return text;
}

/// The frame of a JSON show, with the counters of the same show as text.
Frame frame_of(const std::string& json_text, const std::string& text) {
  const json show = json::parse(with_real_zeros(json_text)).at("show");
  Frame frame;
  frame.time = show.at("time");
  frame.stopped = show.value("stime", 0);
  frame.mode = *soccer::parse_play_mode(show.at("mode").get<std::string>());

  for (int i = 0; i < 2; ++i) {
    const json& team = show.at("team").at(i == 0 ? "l" : "r");
    TeamFrame& out = frame.teams[base::index(i)];
    if (!team.at("name").is_null()) out.name = team.at("name");
    out.score = team.at("score");
  }

  frame.ball_position = vector_of(show.at("ball"), "x", "y");
  frame.ball_velocity = vector_of(show.at("ball"), "vx", "vy");
  const auto counts = counts_in(text);
  for (std::size_t i = 0; i < frame.players.size(); ++i) {
    frame.players[i] = player_of(show.at("players").at(i));
    frame.players[i].counts = counts_of(counts.at(i));
  }
  return frame;
}

/// The frame of a show in JSON and the newest of the text versions.
Frame frame_of(const RcssserverMessages::ByVersion& show) {
  return frame_of(show.at(-1), show.rbegin()->first >= 3 ? show.rbegin()->second : "");
}

std::string show_of(const Frame& frame, MonitorVersion version) {
  std::string text;
  append_monitor_show(version, frame, text);
  return text;
}

TEST(MonitorMessage, TextAndJsonShowsMatchRcssserver) {
  RcssserverMessages rcssserver;
  std::map<int, int> compared;

  for (const auto& [index, by_version] : rcssserver.of("show")) {
    const Frame frame = frame_of(by_version);
    for (const int version : {-1, 3, 4, 5}) {
      if (by_version.count(version) == 0) continue;
      EXPECT_EQ(show_of(frame, static_cast<MonitorVersion>(version)), by_version.at(version));
      ++compared[version];
    }
  }

  for (const int version : {-1, 3, 4, 5}) EXPECT_GE(compared[version], 2) << version;
}

// Positions are rounded to sixteenths of a meter; the expected ones were rounded before.
void expect_short_show(const std::string& actual, const std::string& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  EXPECT_EQ(actual.substr(0, 40), expected.substr(0, 40));  // mode and teams
  EXPECT_EQ(actual.substr(316), expected.substr(316));      // cycle
  EXPECT_EQ(actual.substr(48, 4), expected.substr(48, 4));  // the bytes before it are undefined
  for (std::size_t at = 52; at < 316; at += 2) {
    EXPECT_NEAR(read_int16(&actual[at]), read_int16(&expected[at]), at % 12 < 4 + 6 ? 1 : 0) << at;
  }
}

TEST(MonitorMessage, Version1ShowsMatchRcssserver) {
  RcssserverMessages rcssserver;

  for (const auto& [index, by_version] : rcssserver.of("show")) {
    const Frame frame = frame_of(by_version);
    expect_short_show(show_of(frame, MonitorVersion::k1), bytes_of(by_version.at(1), 2052));
  }
}

// Reals times 65536; the text has four decimals for meters, three for degrees.
void expect_long_show(const std::string& actual, const std::string& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  EXPECT_EQ(actual.substr(0, 42), expected.substr(0, 42));

  for (std::size_t at = 44; at < 60; at += 4) {
    EXPECT_NEAR(read_int32(&actual[at]), read_int32(&expected[at]), 4) << at;
  }

  for (std::size_t player = 60; player < 1468; player += 64) {
    EXPECT_EQ(actual.substr(player, 4), expected.substr(player, 4));
    for (std::size_t at = player + 4; at < player + 32; at += 4) {
      EXPECT_NEAR(read_int32(&actual[at]), read_int32(&expected[at]), 4) << player << ' ' << at;
    }
    EXPECT_EQ(actual.substr(player + 32, 2), expected.substr(player + 32, 2));
    for (std::size_t at = player + 36; at < player + 48; at += 4) {  // six digits of stamina
      EXPECT_NEAR(read_real(&actual[at]), read_real(&expected[at]), 0.006) << player << ' ' << at;
    }
    EXPECT_EQ(actual.substr(player + 48, 16), expected.substr(player + 48, 16));
  }
  EXPECT_EQ(actual.substr(1468, 2), expected.substr(1468, 2));
}

TEST(MonitorMessage, Version2ShowsMatchRcssserver) {
  RcssserverMessages rcssserver;

  for (const auto& [index, by_version] : rcssserver.of("show")) {
    const Frame frame = frame_of(by_version);
    expect_long_show(show_of(frame, MonitorVersion::k2), bytes_of(by_version.at(2), 2056));
  }
}

TEST(MonitorMessage, TextsMatchRcssserver) {
  RcssserverMessages rcssserver;
  int stopped = 20;

  for (const auto& [index, by_version] : rcssserver.of("msg")) {
    const json message_json = json::parse(by_version.at(-1)).at("msg");
    stopped = message_json.value("stime", 0);
    for (const auto& [version, message] : by_version) {
      std::string actual;
      append_monitor_text(static_cast<MonitorVersion>(version), message_json.at("time"), stopped, 1,
                          message_json.at("message").get<std::string>(), actual);
      const bool binary = version == 1 || version == 2;
      if (!binary) {
        EXPECT_EQ(actual, message);
        continue;
      }
      EXPECT_EQ(actual.size(), version == 1 ? 2052u : 2056u);
      const std::string expected = bytes_of(message, actual.size());
      const std::size_t board = version == 1 ? 2 : 4;  // version 2 has undefined bytes before it
      EXPECT_EQ(actual.substr(0, 2), expected.substr(0, 2));
      EXPECT_EQ(actual.substr(board, 2), expected.substr(board, 2));
      EXPECT_STREQ(actual.c_str() + board + 2, expected.c_str() + board + 2);
    }
  }

  EXPECT_EQ(rcssserver.of("msg").size(), 2u);
}

TEST(MonitorMessage, EscapesTextOnlyInJson) {
  std::string text;
  append_monitor_text(MonitorVersion::k5, 40, 0, 1, "(team_graphic_l (0 0 \"8 8 2 1\"))", text);
  EXPECT_EQ(text, "(msg 40 1 \"(team_graphic_l (0 0 \"8 8 2 1\"))\")");

  text.clear();
  append_monitor_text(MonitorVersion::kJson, 40, 0, 1, "a \"b\"", text);
  EXPECT_EQ(text, R"({"msg":{"time":40,"board":1,"message":"a \"b\""}})");
  text.clear();
  append_monitor_text(MonitorVersion::k1, 40, 0, 1, std::string(5000, 'x'), text);
  EXPECT_EQ(text.size(), 2052u);
  EXPECT_EQ(text.back(), '\0');
}

template <typename Params>
void expect_parameters(RcssserverMessages& rcssserver, const std::string& kind) {
  for (const auto& [index, by_version] : rcssserver.of(kind)) {
    Params params;
    ASSERT_TRUE(soccer::parse(by_version.at(5), params));
    for (const int version : {-1, 5}) {
      std::string actual;
      append_monitor_parameters(static_cast<MonitorVersion>(version), params, actual);
      EXPECT_EQ(actual, by_version.at(version));
    }
  }
}

TEST(MonitorMessage, ParametersMatchRcssserver) {
  RcssserverMessages rcssserver;
  expect_parameters<soccer::ServerParams>(rcssserver, "server_param");
  expect_parameters<soccer::PlayerParams>(rcssserver, "player_param");
  expect_parameters<soccer::PlayerType>(rcssserver, "player_type");
}

template <typename Params>
void expect_binary(RcssserverMessages& rcssserver, const std::string& kind, std::size_t size,
                   std::int32_t tolerance) {
  for (const auto& [index, by_version] : rcssserver.of(kind)) {
    Params params;
    ASSERT_TRUE(soccer::parse(by_version.at(5), params));
    std::string actual;
    append_monitor_parameters(MonitorVersion::k2, params, actual);

    const std::string expected = bytes_of(by_version.at(2), 2056);
    ASSERT_EQ(actual.size(), expected.size());
    EXPECT_EQ(actual.substr(0, 2), expected.substr(0, 2));

    // Bytes after it, and after single two-byte numbers, are undefined.
    for (std::size_t at = 4; at < 4 + size; at += 4) {
      const bool alone = kind == "player_type" ? at == 4 : kind == "player_param" && at == 8;
      if (alone) {
        EXPECT_EQ(read_int16(&actual[at]), read_int16(&expected[at]));
        continue;
      }
      EXPECT_NEAR(read_int32(&actual[at]), read_int32(&expected[at]), tolerance)
          << kind << ' ' << at - 4;
    }
  }
}

TEST(MonitorMessage, BinaryParametersMatchRcssserver) {
  RcssserverMessages rcssserver;
  expect_binary<soccer::ServerParams>(rcssserver, "server_param", kServerParamSize, 0);
  expect_binary<soccer::PlayerParams>(rcssserver, "player_param", 108, 0);
  expect_binary<soccer::PlayerType>(rcssserver, "player_type", 60, 4);  // known to six digits
}

TEST(MonitorMessage, SendsNoParametersToVersion1AndAllToVersion5) {
  const std::vector<soccer::PlayerType> types(3);
  std::vector<std::string> sent;
  const auto send = [&sent](std::string_view message) { sent.emplace_back(message); };
  send_monitor_parameters(MonitorVersion::k1, {}, {}, types, send);
  EXPECT_TRUE(sent.empty());

  send_monitor_parameters(MonitorVersion::k5, {}, {}, types, send);
  ASSERT_EQ(sent.size(), 5u);
  EXPECT_TRUE(sent[0].starts_with("(server_param (audio_cut_dist 50)"));
  EXPECT_TRUE(sent[1].starts_with("(player_param "));
  EXPECT_TRUE(sent[4].starts_with("(player_type (id "));
}

}  // namespace
}  // namespace cls::gamelog
