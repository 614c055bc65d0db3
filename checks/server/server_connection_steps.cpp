// Steps: connecting to a soccer server and its initial messages.
#include <fmt/format.h>

#include "checks/server/server_subject.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/messages/server_reply.h"

namespace cls::checks {
namespace {

constexpr const char* kOwnTeam = "Check_A";
constexpr const char* kOthers = "Check_B";

std::string init(const std::string& team, int version, bool goalie = false) {
  return fmt::format("(init {} (version {}){})", team, version, goalie ? " (goalie)" : "");
}

Finding first_part(const std::optional<std::string>& message) {
  return message ? pass(message->substr(0, 80)) : fail("no reply");
}

// The reply must be an error with any text.
Finding refused(ServerSubject& subject, const std::string& request) {
  ServerClient& client = subject.connect(*subject.player_port, request);
  const auto answer = subject.await(client, is_reply);
  subject.clients.pop_back();
  if (!answer) return fail(request + ": no reply");
  const std::string evidence = request + ": " + *answer;
  return answer->starts_with("(error") ? pass(evidence) : fail(evidence);
}

Finding reach(ServerSubject& subject) {
  const auto end = std::chrono::steady_clock::now() + subject.start_timeout;
  while (std::chrono::steady_clock::now() < end) {
    ServerClient& client = subject.connect(*subject.player_port, init(kOwnTeam, 18));
    const auto answer = subject.await(client, is_reply, std::chrono::milliseconds(500));
    if (answer && answer->starts_with("(init")) return pass(*answer);
    if (answer) return fail(*answer);

    subject.clients.clear();
    if (const std::string reason = subject.failure_reason(); !reason.empty()) {
      return fail("no reply to (init ...); " + reason);
    }
  }
  return fail("no reply to (init ...)");
}

Finding server_param(ServerSubject& subject) {
  const auto message = subject.await(subject.player(), starts_with_text("(server_param "));
  if (!message) return fail("no server_param");
  soccer::ServerParams params;
  const auto read = soccer::parse(*message, params);
  return read ? pass("{} bytes", message->size()) : fail(read.error().message);
}

Finding player_param(ServerSubject& subject) {
  const auto message = subject.await(subject.player(), starts_with_text("(player_param "));
  if (!message) return fail("no player_param");
  soccer::PlayerParams params;
  const auto read = soccer::parse(*message, params);
  return read ? pass("{} player types", params.player_types) : fail(read.error().message);
}

Finding player_types(ServerSubject& subject) {
  constexpr int kTypes = 18;
  for (int i = 0; i < kTypes; ++i) {
    const auto message = subject.await(subject.player(), starts_with_text("(player_type "));
    if (!message) return fail("{} of {} types", i, kTypes);
    soccer::PlayerType type;
    if (const auto read = soccer::parse(*message, type); !read) return fail(read.error().message);
  }
  return pass("{} types", kTypes);
}

Finding goalie(ServerSubject& subject) {
  ServerClient& client = subject.connect(*subject.player_port, init(kOwnTeam, 18, true));
  const auto answer = subject.await(client, is_reply);
  if (!answer) return fail("no reply");
  soccer::ServerReply reply;
  const auto read = soccer::parse(*answer, reply);
  const auto* received = std::get_if<soccer::PlayerInitReply>(&reply);
  return read && received != nullptr && received->unum == 2 ? pass(*answer) : fail(*answer);
}

Finding second_goalie(ServerSubject& subject) { return refused(subject, init(kOwnTeam, 18, true)); }

Finding bad_name(ServerSubject& subject) { return refused(subject, init("Not%A.Name", 18)); }
Finding long_name(ServerSubject& subject) { return refused(subject, init("SixteenLettersXX", 18)); }
Finding stranger(ServerSubject& subject) { return refused(subject, "(dash 100)"); }

Finding versions(ServerSubject& subject) {
  std::string joined;
  for (int version = 8; version <= 17; ++version) {
    ServerClient& client = subject.connect(*subject.player_port, init(kOthers, version));
    const auto answer = subject.await(client, is_reply);
    if (!answer || !answer->starts_with("(init r")) {
      return fail("version {}: {}", version, answer.value_or("no reply"));
    }

    if (!subject.await(client, starts_with_text("(server_param "))) {
      return fail("version {}: no server_param", version);
    }
    joined += fmt::format(" {}", version);
  }
  return pass("versions" + joined);
}

Finding newest_version(ServerSubject& subject) {
  ServerClient& client = subject.connect(*subject.player_port, init(kOthers, 19));
  return first_part(subject.await(client, starts_with_text("(init r 11 ")));
}

Finding full_team(ServerSubject& subject) { return refused(subject, init(kOthers, 18)); }
Finding third_team(ServerSubject& subject) { return refused(subject, init("Check_C", 18)); }

Finding monitor(ServerSubject& subject) {
  ServerClient& client = subject.connect(*subject.player_port, "(dispinit version 4)");
  return first_part(subject.await(client, starts_with_text("(show ")));
}

Finding coach(ServerSubject& subject) {
  ServerClient& client =
      subject.connect(*subject.coach_port, fmt::format("(init {} (version 18))", kOwnTeam));
  const auto answer = subject.await(client, is_reply);
  if (!answer) return fail("no reply on the port of online coaches");
  if (!answer->starts_with("(init l ok)")) return fail(*answer);
  client.channel->send("(eye on)");
  const auto view = subject.await(client, starts_with_text("(see_global "));
  return view ? pass(*answer + ", eye on, see_global") : fail("no see_global after (eye on)");
}

Finding trainer(ServerSubject& subject) {
  ServerClient& client = subject.connect(*subject.trainer_port, "(init (version 18))");
  const auto answer = subject.await(client, is_reply);
  if (!answer) {
    subject.clients.pop_back();
    return skip("no reply: servers without server::coach have no trainer port");
  }
  return answer->starts_with("(init ok)") ? pass(*answer) : fail(*answer);
}

}  // namespace

std::vector<ServerStep> server_connection_steps() {
  return {
      {"reach", "Nothing works before the first player is accepted.", reach},
      {"server_param", "Clients compute with these values.", server_param},
      {"player_param", "Clients compute with these values.", player_param},
      {"player_types", "Without all types, players compute with wrong physics.", player_types},
      {"goalie", "Uniform numbers are assigned in order of connection; the goalie is marked.",
       goalie},
      {"second_goalie", "A team has one goalie.", second_goalie},
      {"bad_team_name", "Names are part of messages: parentheses and dots would break them.",
       bad_name},
      {"long_team_name", "Names have up to 15 characters.", long_name},
      {"stranger", "Commands of clients that are not connected are refused.", stranger},
      {"versions_8_to_17", "Older teams use these protocol versions.", versions},
      {"version_19", "The newest protocol.", newest_version},
      {"full_team", "A team has 11 players.", full_team},
      {"third_team", "A match has two teams.", third_team},
      {"monitor", "Monitors display the match.", monitor},
      {"online_coach", "Coaches substitute players and see the whole pitch.", coach},
      {"trainer", "Training sessions require it.", trainer},
  };
}

}  // namespace cls::checks
