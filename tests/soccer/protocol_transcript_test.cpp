// Every recorded message of the real server parses, and formats back to the same bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "soccer/protocol/coach_command.h"
#include "soccer/protocol/connection_request.h"
#include "soccer/protocol/full_state.h"
#include "soccer/protocol/global_view.h"
#include "soccer/protocol/hear.h"
#include "soccer/protocol/message_kind.h"
#include "soccer/protocol/parameter_message.h"
#include "soccer/protocol/player_command.h"
#include "soccer/protocol/protocol_version.h"
#include "soccer/protocol/see.h"
#include "soccer/protocol/sense_body.h"
#include "soccer/protocol/server_reply.h"
#include "tests/soccer/transcript.h"
#include "tests/support/files.h"

namespace cls::soccer {
namespace {

using tests::RecordedMessage;
using tests::Role;

// Counts what went through, so that an empty run is not a green one.
struct Counts {
  std::map<std::string, int> passed;

  int of(const std::string& kind) const {
    const auto found = passed.find(kind);
    return found == passed.end() ? 0 : found->second;
  }
};

void print(const std::string& title, const Counts& counts) {
  std::cout << title << '\n';
  for (const auto& [kind, count] : counts.passed) std::cout << "  " << kind << ' ' << count << '\n';
}

template <typename Message, typename Format>
void check(const RecordedMessage& recorded, const std::string& kind, Format format_back,
           Counts& counts, Message message = {}) {
  const Result<void> parsed = parse(recorded.text, message);
  ASSERT_TRUE(parsed) << recorded.place << ": " << parsed.error().message << "\n" << recorded.text;
  std::string text;
  format_back(message, text);
  ASSERT_EQ(text, recorded.text) << recorded.place;
  ++counts.passed[kind];
}

Listener listener_of(Role role) {
  return role == Role::kTrainer       ? Listener::kTrainer
         : role == Role::kOnlineCoach ? Listener::kOnlineCoach
                                      : Listener::kPlayer;
}

void check_server_message(const RecordedMessage& recorded, Counts& counts) {
  if (recorded.role == Role::kPlayer && recorded.version < kOldestProtocolVersion) {
    ++counts.passed["messages of older versions, left out"];
    return;
  }
  const auto versioned = [&](const auto& message, std::string& out) {
    format(message, recorded.version, out);
  };
  const auto plain = [](const auto& message, std::string& out) { format(message, out); };
  switch (message_kind(recorded.text)) {
    case MessageKind::kSenseBody:
      return check<SenseBody>(recorded, "sense_body", versioned, counts);
    case MessageKind::kSee:
      return check<See>(recorded, "see", plain, counts);
    case MessageKind::kHear:
      return check<Hear>(
          recorded, "hear",
          [&](const Hear& hear, std::string& out) {
            format(hear, listener_of(recorded.role), out);
          },
          counts);
    case MessageKind::kFullState:
      return check<FullState>(recorded, "fullstate", versioned, counts);
    case MessageKind::kGlobalView:
      return check<GlobalView>(recorded, "see_global", plain, counts);
    case MessageKind::kServerParam:
      return check<ServerParams>(recorded, "server_param", versioned, counts);
    case MessageKind::kPlayerParam:
      return check<PlayerParams>(recorded, "player_param", versioned, counts);
    case MessageKind::kPlayerType:
      return check<PlayerType>(recorded, "player_type", versioned, counts);
    case MessageKind::kReply:
      return check<ServerReply>(
          recorded, "reply " + recorded.text.substr(1, recorded.text.find_first_of(" )") - 1),
          plain, counts);
    case MessageKind::kUnknown:
      break;
  }
  const bool monitor = recorded.role == Role::kMonitor &&
                       (recorded.text.starts_with("(show ") || recorded.text.starts_with("(msg "));
  ASSERT_TRUE(monitor) << recorded.place << ": " << recorded.text;
}

void check_player_commands(const RecordedMessage& recorded, Counts& counts) {
  std::vector<PlayerCommand> commands;
  const std::optional<std::size_t> error = parse_player_commands(recorded.text, commands);
  if (error) {
    ++counts.passed["player datagrams with an error"];
    return;
  }
  std::string text;
  for (const PlayerCommand& command : commands)
    ASSERT_TRUE(format(command, text)) << recorded.place;
  std::vector<PlayerCommand> again;
  ASSERT_FALSE(parse_player_commands(text, again)) << recorded.place << ": " << text;
  ASSERT_EQ(again.size(), commands.size()) << recorded.place;
  std::string text_again;
  for (const PlayerCommand& command : again) ASSERT_TRUE(format(command, text_again));
  ASSERT_EQ(text_again, text) << recorded.place;
  ++counts.passed["player datagrams"];
  counts.passed["player commands"] += static_cast<int>(commands.size());
  if (text == recorded.text) ++counts.passed["player datagrams with identical text"];
}

void check_coach_command(const RecordedMessage& recorded, Counts& counts) {
  const CoachRole role =
      recorded.role == Role::kTrainer ? CoachRole::kTrainer : CoachRole::kOnlineCoach;
  CoachCommand command;
  if (parse(recorded.text, role, command)) {
    ++counts.passed["coach commands with an error"];
    return;
  }
  std::string text;
  ASSERT_TRUE(format(command, text)) << recorded.place;
  ++counts.passed["coach commands"];
  if (text == recorded.text) ++counts.passed["coach commands with identical text"];
}

void check_client_message(const RecordedMessage& recorded, Counts& counts) {
  if (recorded.role == Role::kPlayer) return check_player_commands(recorded, counts);
  if (recorded.role == Role::kTrainer || recorded.role == Role::kOnlineCoach) {
    return check_coach_command(recorded, counts);
  }
}

Counts check_files(const std::vector<std::filesystem::path>& files) {
  Counts counts;
  for (const std::filesystem::path& file : files) {
    for (const RecordedMessage& recorded : tests::read_transcript(file)) {
      if (recorded.from_server) {
        check_server_message(recorded, counts);
      } else {
        check_client_message(recorded, counts);
      }
      if (testing::Test::HasFatalFailure()) return counts;
    }
  }
  return counts;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".gz") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ProtocolTranscript, AllRecordedMessagesOfTheRealServerRoundTripByteForByte) {
  const auto udp = tests::data("udp");
  const auto aligned = tests::data("aligned/udp");
  if (!udp || !aligned) GTEST_SKIP() << "no data: set CLS_DATA";
  std::vector<std::filesystem::path> files = files_in(*udp);
  const std::vector<std::filesystem::path> more = files_in(*aligned);
  files.insert(files.end(), more.begin(), more.end());
  const Counts counts = check_files(files);
  print("recorded messages that went through:", counts);
  for (const auto& [kind, least] : std::map<std::string, int>{{"sense_body", 7000},
                                                              {"see", 4000},
                                                              {"hear", 11000},
                                                              {"fullstate", 1200},
                                                              {"see_global", 2900},
                                                              {"player_type", 900},
                                                              {"server_param", 50},
                                                              {"player_param", 50},
                                                              {"reply think", 7000},
                                                              {"reply ok", 150},
                                                              {"player commands", 24000},
                                                              {"coach commands", 2000}}) {
    EXPECT_GE(counts.of(kind), least) << kind;
  }
}

}  // namespace
}  // namespace cls::soccer
