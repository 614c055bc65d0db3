// All recorded messages of rcssserver parse and format to the same bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "soccer/commands/coach_command.h"
#include "soccer/commands/connection_request.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/full_state.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/messages/server_reply.h"
#include "soccer/protocol/message_kind.h"
#include "soccer/protocol/protocol_version.h"
#include "tests/soccer/transcript.h"
#include "tests/support/files.h"

namespace cls::soccer {
namespace {

using tests::RecordedMessage;
using tests::Role;

// Counts messages, so that a run without messages fails.
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
  const base::Result<void> parsed = parse(recorded.text, message);
  ASSERT_TRUE(parsed) << recorded.place << ": " << parsed.error().message << "\n" << recorded.text;
  std::string text;
  format_back(message, text);
  ASSERT_EQ(text, recorded.text) << recorded.place;
  ++counts.passed[kind];
}

Recipient recipient_of(Role role) {
  return role == Role::kTrainer       ? Recipient::kTrainer
         : role == Role::kOnlineCoach ? Recipient::kOnlineCoach
                                      : Recipient::kPlayer;
}

void check_server_message(const RecordedMessage& recorded, Counts& counts) {
  if (recorded.role == Role::kPlayer && recorded.version < kMinProtocolVersion) {
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
            format(hear, recipient_of(recorded.role), out);
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

TEST(ProtocolTranscript, ExcerptsRoundTripByteForByte) {
  const Counts counts = check_files(files_in(tests::fixture("protocol")));
  print("parsed messages in excerpts:", counts);

  for (const auto& [kind, min_count] : std::map<std::string, int>{{"sense_body", 500},
                                                                  {"see", 300},
                                                                  {"hear", 400},
                                                                  {"fullstate", 100},
                                                                  {"see_global", 100},
                                                                  {"player_type", 300},
                                                                  {"server_param", 20},
                                                                  {"player_param", 20},
                                                                  {"reply ok", 90},
                                                                  {"player commands", 300},
                                                                  {"coach commands", 100}}) {
    EXPECT_GE(counts.of(kind), min_count) << kind;
  }
}

// Errors of one client: those of the parsers and those that the server sent.
struct Errors {
  std::map<std::string, int> expected;
  std::map<std::string, int> received;
  bool connecting = false;  ///< the last datagram was an init or reconnect, which have other errors
};

// The errors that depend on the text alone.
bool is_form_error(const std::string& name) {
  static const std::set<std::string> names = {"illegal_command_form", "unknown_command",
                                              "illegal_object_form", "could_not_parse_say",
                                              "illegal_mode"};
  return names.contains(name);
}

std::optional<ErrorCode> error_of(const RecordedMessage& recorded) {
  if (recorded.role == Role::kPlayer) {
    std::vector<PlayerCommand> commands;
    const bool wrong = parse_player_commands(recorded.text, commands).has_value();
    return wrong ? std::optional(ErrorCode::kIllegalCommandForm) : std::nullopt;
  }

  CoachCommand command;
  return parse(recorded.text,
               recorded.role == Role::kTrainer ? CoachRole::kTrainer : CoachRole::kOnlineCoach,
               command);
}

void note_error(const RecordedMessage& recorded, Errors& errors) {
  if (recorded.from_server) {
    ServerReply reply;
    if (errors.connecting || !recorded.text.starts_with("(error ")) return;
    ASSERT_TRUE(parse(recorded.text, reply));
    const std::string& text = std::get<ErrorReply>(reply).text;
    if (is_form_error(text)) ++errors.received[text];
    return;
  }
  errors.connecting = recorded.text.starts_with("(init") || recorded.text.starts_with("(reconnect");

  // A trainer sends bye to a server that has exited.
  if (errors.connecting || recorded.text == "(bye)") return;
  const std::optional<ErrorCode> error = error_of(recorded);

  if (error && is_form_error(std::string(name(*error)))) {
    ++errors.expected[std::string(name(*error))];
  }
}

TEST(ProtocolTranscript, ParsersReturnSyntaxErrorsOfRcssserver) {
  int total = 0;

  for (const std::filesystem::path& file : files_in(tests::fixture("protocol"))) {
    std::map<std::string, Errors> clients;
    for (const RecordedMessage& recorded : tests::read_transcript(file)) {
      if (recorded.role == Role::kMonitor || recorded.role == Role::kUnknown) continue;
      note_error(recorded, clients[recorded.client]);
    }
    for (const auto& [client, errors] : clients) {
      EXPECT_EQ(errors.expected, errors.received) << file << " " << client;
      for (const auto& [name, count] : errors.received) total += count;
    }
  }

  EXPECT_GE(total, 20);
}

TEST(ProtocolTranscript, AllRecordedMessagesRoundTripByteForByte) {
  const auto udp = tests::data("udp");
  const auto aligned = tests::data("aligned/udp");
  if (!udp || !aligned) GTEST_SKIP() << "no data: set CLS_DATA";
  std::vector<std::filesystem::path> files = files_in(*udp);
  const std::vector<std::filesystem::path> more = files_in(*aligned);
  files.insert(files.end(), more.begin(), more.end());
  const Counts counts = check_files(files);
  print("parsed recorded messages:", counts);

  for (const auto& [kind, min_count] : std::map<std::string, int>{{"sense_body", 7000},
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
    EXPECT_GE(counts.of(kind), min_count) << kind;
  }
}

// "12,0<tab>Recv TEAM_7: (dash 100)(turn 5)": the player commands of a whole match.
TEST(ProtocolTranscript, AllCommandsInTextLogsParse) {
  int datagrams = 0;
  std::vector<PlayerCommand> commands;

  for (const char* log : {"logs/helios-vs-helios-full.rcl.gz", "logs/cyrus-vs-helios-full.rcl.gz",
                          "noise-free/game.rcl.gz", "aligned/game.rcl.gz"}) {
    const auto path = tests::data(log);
    if (!path) GTEST_SKIP() << "no data: set CLS_DATA";
    std::istringstream lines(tests::read_file(*path));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t start = line.find(": (");
      const bool player = start != std::string::npos && line.find("\tRecv ") < start &&
                          std::isdigit(static_cast<unsigned char>(line[start - 1])) != 0;
      if (!player || line.compare(start + 2, 6, "(init ") == 0) continue;
      const std::string_view datagram = std::string_view(line).substr(start + 2);
      commands.clear();
      const std::optional<std::size_t> error = parse_player_commands(datagram, commands);
      ASSERT_FALSE(error) << log << " byte " << *error << ": " << datagram;
      std::string text;
      for (const PlayerCommand& command : commands) ASSERT_TRUE(format(command, text));
      ++datagrams;
    }
  }

  std::cout << datagrams << " player datagrams parsed\n";
  EXPECT_GT(datagrams, 300000);
}

}  // namespace
}  // namespace cls::soccer
