// Steps: sensor messages, effects of commands, disconnecting.
#include <fmt/format.h>

#include "checks/server/server_subject.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"

namespace cls::checks {
namespace {

using soccer::SenseBody;

// The next sense_body for which `is` holds, within a few messages.
template <typename Is>
std::optional<SenseBody> sensed(ServerSubject& subject, Is is) {
  for (int i = 0; i < 20; ++i) {
    const auto message = subject.await(subject.player(), starts_with_text("(sense_body "));
    SenseBody sense;
    if (!message || !soccer::parse(*message, sense)) return std::nullopt;
    if (is(sense)) return sense;
  }
  return std::nullopt;
}

Finding sense_body(ServerSubject& subject) {
  const auto message = subject.await(subject.player(), starts_with_text("(sense_body "));
  if (!message) return fail("no sense_body");
  SenseBody sense;
  const auto read = soccer::parse(*message, sense);
  return read ? pass(message->substr(0, 60)) : fail(read.error().message);
}

Finding see(ServerSubject& subject) {
  const auto message = subject.await(subject.player(), starts_with_text("(see "));
  if (!message) return fail("no see");
  soccer::See seen;
  const auto read = soccer::parse(*message, seen);
  return read ? pass("{} objects", seen.objects.size()) : fail(read.error().message);
}

Finding old_sense_body(ServerSubject& subject) {
  for (std::size_t i = 2; i < 12 && i < subject.clients.size(); ++i) {
    if (!subject.await(*subject.clients[i], starts_with_text("(sense_body "))) {
      return fail("none for client {}", i);
    }
  }
  return pass("one for a client of each version");
}

// Sends a command and waits until its counter has increased.
Finding counted(ServerSubject& subject, const std::string& command, int soccer::CommandCounts::*n) {
  const auto before = sensed(subject, [](const SenseBody&) { return true; });
  if (!before) return fail("no sense_body");
  subject.player().channel->send(command);
  const int was = before->counts.*n;
  const auto after = sensed(subject, [&](const SenseBody& sense) { return sense.counts.*n > was; });
  if (!after) return fail(command + " was not counted");
  return pass("{}: {} before, {} after", command, was, after->counts.*n);
}

Finding move(ServerSubject& subject) {
  return counted(subject, "(move -10 -5)", &soccer::CommandCounts::move);
}
Finding turn(ServerSubject& subject) {
  return counted(subject, "(turn 30)", &soccer::CommandCounts::turn);
}
Finding turn_neck(ServerSubject& subject) {
  return counted(subject, "(turn_neck 20)", &soccer::CommandCounts::turn_neck);
}
Finding several(ServerSubject& subject) {
  return counted(subject, "(turn 10)(turn_neck -10)(change_view narrow)",
                 &soccer::CommandCounts::change_view);
}

Finding view(ServerSubject& subject) {
  subject.player().channel->send("(change_view wide)");
  const auto after = sensed(
      subject, [](const SenseBody& sense) { return sense.width == soccer::ViewWidth::kWide; });
  return after ? pass("(change_view wide), then reported in sense_body")
               : fail("the view did not change");
}

Finding say(ServerSubject& subject) {
  subject.goalie().inbox.clear();
  subject.player().channel->send("(say \"hello\")");
  const auto heard = subject.await(subject.goalie(), [](const std::string& message) {
    return message.starts_with("(hear ") && message.find("hello") != std::string::npos;
  });
  return heard ? pass(*heard) : fail("the teammate did not hear it");
}

Finding answered(ServerSubject& subject, const std::string& command, const std::string& wanted) {
  subject.player().channel->send(command);
  const auto answer = subject.await(subject.player(), starts_with_text("(error "));
  const std::string evidence = command + ": " + answer.value_or("no reply");
  return answer && answer->starts_with(wanted) ? pass(evidence) : fail(evidence);
}

Finding bad_form(ServerSubject& subject) {
  return answered(subject, "(dash fast)", "(error illegal_command_form)");
}
Finding unknown_command(ServerSubject& subject) {
  return answered(subject, "(fly 10)", "(error illegal_command_form)");
}

Finding garbage(ServerSubject& subject) {
  std::string bytes;
  for (int i = 0; i < 8000; ++i) bytes.push_back(static_cast<char>(1 + i * 31 % 255));

  for (int i = 0; i < 20; ++i) {
    const auto channel = subject.player_port->connect();
    if (channel != nullptr) channel->send(bytes);
    subject.player().channel->send(bytes.substr(0, 1000));
  }

  subject.player().inbox.clear();
  const auto next = subject.await(subject.player(), starts_with_text("(sense_body "));
  return next ? pass("20 datagrams of 8000 bytes, the match continues")
              : fail("no messages since then");
}

Finding rhythm(ServerSubject& subject) {
  constexpr int kCycles = 10;
  const int thinks = subject.thinks;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kCycles; ++i) {
    if (!subject.await(subject.player(), starts_with_text("(sense_body ")))
      return fail("no sense_body");
  }

  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  return pass("{:.1f} ms per cycle, {}", took.count() / kCycles,
              subject.thinks > thinks ? "synch mode" : "real time");
}

Finding bye(ServerSubject& subject) {
  subject.goalie().channel->send("(bye)");
  subject.listen(std::chrono::milliseconds(300));
  subject.goalie().inbox.clear();
  subject.listen(std::chrono::milliseconds(500));
  const std::string evidence =
      fmt::format("{} messages after (bye)", subject.goalie().inbox.size());
  return subject.goalie().inbox.empty() ? pass(evidence) : fail(evidence);
}

Finding reconnect(ServerSubject& subject) {
  ServerClient& client = subject.connect(*subject.player_port, "(reconnect Check_A 2)");
  const auto answer = subject.await(client, [](const std::string& message) {
    return message.starts_with("(reconnect") || message.starts_with("(error");
  });
  if (!answer || !answer->starts_with("(reconnect l ")) {
    return fail(answer.value_or("no reply"));
  }
  return subject.await(client, starts_with_text("(sense_body ")) ? pass(*answer)
                                                                 : fail("no sense_body");
}

Finding still_there(ServerSubject& subject) {
  subject.player().inbox.clear();
  const auto next = subject.await(subject.player(), starts_with_text("(sense_body "));
  return next ? pass("the first player receives sense_body") : fail("no messages");
}

}  // namespace

std::vector<ServerStep> server_play_steps() {
  return {
      {"sense_body", "It reports the player's own body.", sense_body},
      {"see", "It reports the objects in view.", see},
      {"sense_body_of_versions", "Each protocol version has its own format.", old_sense_body},
      {"move", "Before a kick-off players move to their positions.", move},
      {"turn", "One body command per cycle is executed and counted.", turn},
      {"turn_neck", "It is executed in addition to a body command.", turn_neck},
      {"several_commands", "A datagram may hold several commands.", several},
      {"change_view", "It determines view width and interval.", view},
      {"say_and_hear", "Teammates communicate with say messages.", say},
      {"illegal_command_form", "Error messages help authors to find bugs.", bad_form},
      {"unknown_command", "Error messages help authors to find bugs.", unknown_command},
      {"garbage", "Any process can send any bytes to a UDP port.", garbage},
      {"rhythm", "Duration of a cycle, and its clock.", rhythm},
      {"bye", "Disconnected clients receive no messages.", bye},
      {"reconnect", "A disconnected player returns with the same uniform number.", reconnect},
      {"still_there", "It must continue to serve after all steps.", still_there},
  };
}

}  // namespace cls::checks
