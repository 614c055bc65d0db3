// Parses and replays conversations.
#include "tests/simulator/sessions/conversation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "base/text/number_text.h"
#include "soccer/memory_channel.h"
#include "tests/support/rcg_lines.h"

namespace cls::tests {
namespace {

using simulator::ListeningPort;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// In the pattern, '#' matches an integer and '@' the letter of a side.
bool matches(std::string_view pattern, std::string_view text) {
  std::size_t at = 0;
  for (const char c : pattern) {
    if (c == '@') {
      if (at == text.size() || (text[at] != 'l' && text[at] != 'r')) return false;
      ++at;
      continue;
    }
    if (c != '#') {
      if (at == text.size() || text[at++] != c) return false;
      continue;
    }
    const std::size_t start = at;
    if (at < text.size() && text[at] == '-') ++at;
    while (at < text.size() && is_digit(text[at])) ++at;
    if (at == start) return false;
  }

  return at == text.size();
}

bool match(const std::vector<std::string>& texts, const std::vector<std::string>& patterns) {
  return std::equal(texts.begin(), texts.end(), patterns.begin(), patterns.end(),
                    [](const auto& text, const auto& pattern) { return matches(pattern, text); });
}

bool match_in_any_order(const std::vector<std::string>& texts, std::vector<std::string> patterns) {
  for (const std::string& text : texts) {
    const auto found = std::find_if(patterns.begin(), patterns.end(),
                                    [&](const auto& pattern) { return matches(pattern, text); });
    if (found == patterns.end()) return false;
    patterns.erase(found);
  }
  return patterns.empty();
}

// Splits "L1 (dash 100)" at the first space.
std::pair<std::string, std::string> split(std::string_view text) {
  const std::size_t space = std::min(text.find(' '), text.size());
  return {std::string(text.substr(0, space)),
          std::string(text.substr(std::min(space + 1, text.size())))};
}

void parse_line(std::string_view line, Conversation& out) {
  const std::string_view rest = line.substr(std::min<std::size_t>(2, line.size()));
  const auto last = [&]() -> Turn& {
    if (out.turns.empty()) throw std::runtime_error("no datagram before this line");
    return out.turns.back();
  };

  switch (line.front()) {
    case '=':
      out.settings.emplace_back(rest);
      return;
    case '-':
      out.ignored.emplace_back(rest);
      return;
    case '@':
      if (out.turns.empty()) out.turns.emplace_back();
      last().included.emplace_back(rest);
      return;
    case '+':
      out.turns.emplace_back().cycles = base::parse_int(rest).value();
      return;
    case '>': {
      Turn& turn = out.turns.emplace_back();
      std::tie(turn.client, turn.sent) = split(rest);
      return;
    }
    case '?':
      last().latest.push_back(split(rest));
      return;
    case '<': {
      auto [client, message] = split(rest);
      if (const std::size_t at = message.rfind("\\n"); at != std::string::npos) {
        message.replace(at, 2, "\n");
      }
      last().received[client].push_back(std::move(message));
      return;
    }
    default:
      throw std::runtime_error("invalid line: " + std::string(line));
  }
}

/// A match server with clients on memory channels.
class MemoryHost : public Host {
 public:
  explicit MemoryHost(const std::vector<std::string>& settings) {
    simulator::MatchConfig config;
    for (const std::string& setting : settings) apply(setting, config);
    server_ = std::move(*simulator::MatchServer::create(config));
  }

  void send(const std::string& client, const std::string& datagram) override {
    Client& known = clients_[client];
    if (server_->connection(known.id) == nullptr || known.refused) {
      connect(client, datagram, known);
    } else {
      server_->receive(known.id, datagram);
      server_->execute();
    }
  }

  void pass_cycles(int count) override {
    for (int i = 0; i < count; ++i) {
      server_->step();
      server_->sense();
    }
  }

  std::vector<std::string> receive(const std::string& client, std::size_t,
                                   const std::vector<std::string>& included) override {
    Client& known = clients_[client];
    std::vector<std::string> received = std::move(known.refusals);
    known.refusals.clear();
    std::string message;
    while (known.channel != nullptr && known.channel->receive(message)) {
      record(client, message);
      if (is_relevant(message, included)) received.push_back(message);
    }
    return received;
  }

  std::vector<std::string> clients() const override {
    std::vector<std::string> names;
    for (const auto& [name, client] : clients_) names.push_back(name);
    return names;
  }

 private:
  struct Client {
    simulator::ClientId id = 0;
    bool refused = true;
    std::unique_ptr<soccer::Channel> channel;
    std::vector<std::string> refusals;
  };

  static void apply(const std::string& setting, simulator::MatchConfig& config) {
    const std::size_t colons = setting.find("::");
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(colons + 2, equals - colons - 2);
    const std::string value = setting.substr(equals + 1);
    const bool applied =
        setting.starts_with("player::")
            ? bool(soccer::set_parameter(config.player, soccer::player_param_table(), name, value))
            : bool(soccer::set_parameter(config.server, soccer::server_param_table(), name, value));
    if (!applied) throw std::runtime_error("unknown parameter: " + setting);
  }

  void connect(const std::string& client, const std::string& datagram, Client& known) {
    const auto admission = server_->admit(port_of(client), datagram);
    if (const auto* error = std::get_if<soccer::ErrorCode>(&admission)) {
      soccer::format(*error, known.refusals.emplace_back());
      return;
    }
    auto [server_end, client_end] = soccer::make_memory_channel();
    known.id = std::get<simulator::Admission>(admission).client;
    known.refused = false;
    known.channel = std::move(client_end);
    server_->complete_handshake(std::get<simulator::Admission>(admission), std::move(server_end),
                                datagram);
  }

  std::unique_ptr<simulator::MatchServer> server_;
  std::map<std::string, Client> clients_;
};

void expect_received(const Turn& turn, const std::string& client,
                     const std::vector<std::string>& received, bool in_order) {
  const auto found = turn.received.find(client);
  const std::vector<std::string> expected =
      found == turn.received.end() ? std::vector<std::string>() : found->second;
  if (in_order ? match(received, expected) : match_in_any_order(received, expected)) return;
  EXPECT_EQ(received, expected) << "line " << turn.line << ", received by " << client << " after "
                                << turn.client << ' ' << turn.sent;
}

}  // namespace

Conversation parse_conversation(std::string_view text) {
  Conversation conversation;
  int number = 0;
  for (const std::string_view line : split_lines(text)) {
    ++number;
    if (line.empty() || line.front() == ' ') continue;
    const std::size_t before = conversation.turns.size();
    parse_line(line, conversation);
    if (conversation.turns.size() > before) conversation.turns.back().line = number;
  }
  return conversation;
}

ListeningPort port_of(const std::string& client) {
  if (client.starts_with('C')) return ListeningPort::kOnlineCoaches;
  return client.starts_with('T') ? ListeningPort::kTrainers : ListeningPort::kPlayers;
}

bool is_relevant(std::string_view message, const std::vector<std::string>& included) {
  const auto begins = [message](std::string_view start) { return message.starts_with(start); };
  if (std::any_of(included.begin(), included.end(), begins)) return true;
  const std::string_view ignored_prefixes[] = {"(sense_body ",   "(see ",         "(see_global ",
                                               "(fullstate ",    "(think)",       "(server_param ",
                                               "(player_param ", "(player_type ", "(show "};
  return std::none_of(std::begin(ignored_prefixes), std::end(ignored_prefixes), begins);
}

void replay_conversation(const Conversation& conversation, Host& host) {
  std::vector<std::string> included;
  for (std::size_t i = 0; i < conversation.turns.size(); ++i) {
    Turn turn = conversation.turns[i];
    if (turn.client.empty()) {
      host.pass_cycles(turn.cycles);
    } else {
      host.send(turn.client, turn.sent);
    }

    // The clock of a process runs freely: messages before and in the next cycle are one set.
    bool in_order = true;
    while (i + 1 < conversation.turns.size() && conversation.turns[i + 1].client.empty()) {
      const Turn& pause = conversation.turns[++i];
      in_order = false;
      host.pass_cycles(pause.cycles);
      turn.latest.insert(turn.latest.end(), pause.latest.begin(), pause.latest.end());
      for (const auto& [client, messages] : pause.received) {
        auto& received = turn.received[client];
        received.insert(received.end(), messages.begin(), messages.end());
      }
    }

    for (const std::string& client : host.clients()) {
      const auto found = turn.received.find(client);
      const std::size_t expected = found == turn.received.end() ? 0 : found->second.size();
      const auto received = host.receive(client, expected, included);
      const auto& ignored = conversation.ignored;
      if (std::find(ignored.begin(), ignored.end(), client) != ignored.end()) continue;
      expect_received(turn, client, received, in_order);
    }

    for (const auto& [client, message] : turn.latest) {
      const std::string latest = host.latest(client, message.substr(0, message.find(' ')));
      EXPECT_TRUE(matches(message, latest)) << "line " << turn.line << ", " << client
                                            << " received " << latest << " instead of " << message;
    }

    included.insert(included.end(), turn.included.begin(), turn.included.end());
  }
}

std::unique_ptr<Host> make_memory_host(const std::vector<std::string>& settings) {
  return std::make_unique<MemoryHost>(settings);
}

}  // namespace cls::tests
