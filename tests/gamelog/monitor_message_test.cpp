// Messages to monitors, held against those that rcssserver 19 sent to six monitors at once.
#include "gamelog/rcg/monitor_message.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "gamelog/rcg/binary_params.h"
#include "soccer/messages/parameter_message.h"
#include "tests/support/files.h"

namespace cls::gamelog {
namespace {

using nlohmann::json;

/// What the real server sent: by kind, place in the sequence, and version. Binary messages are in
/// hexadecimal digits, without the NULs at their end.
class RealMessages {
 public:
  RealMessages() {
    std::istringstream lines(tests::read_file(tests::fixture("protocol/monitors.txt.gz")));
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> fields;
      std::size_t begin = 0;
      for (int i = 0; i < 3; ++i) {
        const std::size_t tab = line.find('\t', begin);
        fields.push_back(line.substr(begin, tab - begin));
        begin = tab + 1;
      }
      messages_[fields[0]][std::stoi(fields[1])][std::stoi(fields[2])] = line.substr(begin);
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

// The library takes -0 for an integer, which has no sign.
std::string with_real_zeros(std::string text) {
  for (std::size_t at = 0; (at = text.find(":-0,", at)) != std::string::npos;) {
    text.insert(at + 3, ".0");
  }
  return text;
}

/// The frame that a JSON show tells; the counters from the same show as text.
Frame frame_of(const std::string& json_text, const std::string& text) {
  const json show = json::parse(with_real_zeros(json_text)).at("show");
  Frame frame;
  frame.time = show.at("time");
  frame.stopped = show.value("stime", 0);
  frame.mode = *soccer::play_mode_from_name(show.at("mode").get<std::string>());
  for (int i = 0; i < 2; ++i) {
    const json& team = show.at("team").at(i == 0 ? "l" : "r");
    TeamFrame& out = frame.teams[static_cast<std::size_t>(i)];
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

std::string show_of(const Frame& frame, MonitorVersion version) {
  std::string text;
  append_monitor_show(version, frame, text);
  return text;
}

TEST(MonitorMessage, TextAndJsonShowsAreThoseOfTheRealServer) {
  RealMessages real;
  std::map<int, int> compared;
  for (const auto& [place, by_version] : real.of("show")) {
    std::string text;
    for (const int version : {3, 4, 5}) {
      if (by_version.count(version) > 0) text = by_version.at(version);
    }
    const Frame frame = frame_of(by_version.at(-1), text);
    for (const int version : {-1, 3, 4, 5}) {
      if (by_version.count(version) == 0) continue;
      EXPECT_EQ(show_of(frame, static_cast<MonitorVersion>(version)), by_version.at(version));
      ++compared[version];
    }
  }
  for (const int version : {-1, 3, 4, 5}) EXPECT_GE(compared[version], 2) << version;
}

// Places are rounded to sixteenths of a metre, those that we know were rounded before.
void expect_short_show(const std::string& ours, const std::string& theirs) {
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_EQ(ours.substr(0, 40), theirs.substr(0, 40));  // mode and teams
  EXPECT_EQ(ours.substr(316), theirs.substr(316));      // cycle
  EXPECT_EQ(ours.substr(48, 4), theirs.substr(48, 4));  // ball; before it lies garbage
  for (std::size_t at = 52; at < 316; at += 2) {
    EXPECT_NEAR(read_int16(&ours[at]), read_int16(&theirs[at]), at % 12 < 4 + 6 ? 1 : 0) << at;
  }
}

TEST(MonitorMessage, ShowsOfVersion1AreThoseOfTheRealServer) {
  RealMessages real;
  for (const auto& [place, by_version] : real.of("show")) {
    std::string text;
    for (const auto& [version, message] : by_version) {
      if (version >= 3) text = message;
    }
    const Frame frame = frame_of(by_version.at(-1), text);
    expect_short_show(show_of(frame, MonitorVersion::k1), bytes_of(by_version.at(1), 2052));
  }
}

// Reals times 65536; the text has four decimals of metres, three of degrees.
void expect_long_show(const std::string& ours, const std::string& theirs) {
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_EQ(ours.substr(0, 42), theirs.substr(0, 42));
  for (std::size_t at = 44; at < 60; at += 4) {
    EXPECT_NEAR(read_int32(&ours[at]), read_int32(&theirs[at]), 4) << at;
  }
  for (std::size_t player = 60; player < 1468; player += 64) {
    EXPECT_EQ(ours.substr(player, 4), theirs.substr(player, 4));
    for (std::size_t at = player + 4; at < player + 32; at += 4) {
      EXPECT_NEAR(read_int32(&ours[at]), read_int32(&theirs[at]), 4) << player << ' ' << at;
    }
    EXPECT_EQ(ours.substr(player + 32, 2), theirs.substr(player + 32, 2));
    for (std::size_t at = player + 36; at < player + 48; at += 4) {  // six digits of stamina
      EXPECT_NEAR(read_real(&ours[at]), read_real(&theirs[at]), 0.006) << player << ' ' << at;
    }
    EXPECT_EQ(ours.substr(player + 48, 16), theirs.substr(player + 48, 16));
  }
  EXPECT_EQ(ours.substr(1468, 2), theirs.substr(1468, 2));
}

TEST(MonitorMessage, ShowsOfVersion2AreThoseOfTheRealServer) {
  RealMessages real;
  for (const auto& [place, by_version] : real.of("show")) {
    std::string text;
    for (const auto& [version, message] : by_version) {
      if (version >= 3) text = message;
    }
    const Frame frame = frame_of(by_version.at(-1), text);
    expect_long_show(show_of(frame, MonitorVersion::k2), bytes_of(by_version.at(2), 2056));
  }
}

TEST(MonitorMessage, TextsAreThoseOfTheRealServer) {
  RealMessages real;
  int stopped = 20;
  for (const auto& [place, by_version] : real.of("msg")) {
    const json told = json::parse(by_version.at(-1)).at("msg");
    stopped = told.value("stime", 0);
    for (const auto& [version, message] : by_version) {
      std::string ours;
      append_monitor_text(static_cast<MonitorVersion>(version), told.at("time"), stopped, 1,
                          told.at("message").get<std::string>(), ours);
      const bool binary = version == 1 || version == 2;
      if (!binary) {
        EXPECT_EQ(ours, message);
        continue;
      }
      EXPECT_EQ(ours.size(), version == 1 ? 2052u : 2056u);
      const std::string theirs = bytes_of(message, ours.size());
      const std::size_t board = version == 1 ? 2 : 4;  // version 2 has garbage before it
      EXPECT_EQ(ours.substr(0, 2), theirs.substr(0, 2));
      EXPECT_EQ(ours.substr(board, 2), theirs.substr(board, 2));
      EXPECT_STREQ(ours.c_str() + board + 2, theirs.c_str() + board + 2);
    }
  }
  EXPECT_EQ(real.of("msg").size(), 2u);
}

TEST(MonitorMessage, ATextIsNotEscapedExceptInJson) {
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
void expect_parameters(RealMessages& real, const std::string& kind) {
  for (const auto& [place, by_version] : real.of(kind)) {
    Params params;
    ASSERT_TRUE(soccer::parse(by_version.at(5), params));
    for (const int version : {-1, 5}) {
      std::string ours;
      append_monitor_parameters(static_cast<MonitorVersion>(version), params, ours);
      EXPECT_EQ(ours, by_version.at(version));
    }
  }
}

TEST(MonitorMessage, ParametersAreThoseOfTheRealServer) {
  RealMessages real;
  expect_parameters<soccer::ServerParams>(real, "server_param");
  expect_parameters<soccer::PlayerParams>(real, "player_param");
  expect_parameters<soccer::PlayerType>(real, "player_type");
}

template <typename Params>
void expect_binary(RealMessages& real, const std::string& kind, std::size_t size,
                   std::int32_t tolerance) {
  for (const auto& [place, by_version] : real.of(kind)) {
    Params params;
    ASSERT_TRUE(soccer::parse(by_version.at(5), params));
    std::string ours;
    append_monitor_parameters(MonitorVersion::k2, params, ours);
    const std::string theirs = bytes_of(by_version.at(2), 2056);
    ASSERT_EQ(ours.size(), theirs.size());
    EXPECT_EQ(ours.substr(0, 2), theirs.substr(0, 2));
    // Behind it, and behind the numbers of two bytes that stand alone, is garbage.
    for (std::size_t at = 4; at < 4 + size; at += 4) {
      const bool alone = kind == "player_type" ? at == 4 : kind == "player_param" && at == 8;
      if (alone) {
        EXPECT_EQ(read_int16(&ours[at]), read_int16(&theirs[at]));
        continue;
      }
      EXPECT_NEAR(read_int32(&ours[at]), read_int32(&theirs[at]), tolerance)
          << kind << ' ' << at - 4;
    }
  }
}

TEST(MonitorMessage, BinaryParametersAreThoseOfTheRealServer) {
  RealMessages real;
  expect_binary<soccer::ServerParams>(real, "server_param", kServerParamSize, 0);
  expect_binary<soccer::PlayerParams>(real, "player_param", 108, 0);
  expect_binary<soccer::PlayerType>(real, "player_type", 60, 4);  // known to six digits
}

TEST(MonitorMessage, Version1IsToldNoParametersVersion5All) {
  const std::vector<soccer::PlayerType> types(3);
  std::vector<std::string> told;
  const auto tell = [&told](std::string_view message) { told.emplace_back(message); };
  introduce_to_monitor(MonitorVersion::k1, {}, {}, types, tell);
  EXPECT_TRUE(told.empty());
  introduce_to_monitor(MonitorVersion::k5, {}, {}, types, tell);
  ASSERT_EQ(told.size(), 5u);
  EXPECT_TRUE(told[0].starts_with("(server_param (audio_cut_dist 50)"));
  EXPECT_TRUE(told[1].starts_with("(player_param "));
  EXPECT_TRUE(told[4].starts_with("(player_type (id "));
}

}  // namespace
}  // namespace cls::gamelog
