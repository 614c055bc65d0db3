// Two file formats of recorded sessions.
#include "tests/soccer/transcript.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <sstream>

#include "tests/support/files.h"

namespace cls::tests {
namespace {

struct Client {
  Role role = Role::kUnknown;
  int version = 0;
  std::string name;
  std::string team;
};

void become(Client& client, Role role, int version) {
  client.role = role;
  client.version = version;
}

int version_in(const std::string& request, int missing) {
  const std::size_t at = request.find("version ");
  return at == std::string::npos ? missing : std::atoi(request.c_str() + at + 8);
}

int hex_value(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

// The inside of a quoted literal with \n, \t, \r, \\, \', \" and \xHH.
std::string unescaped(const std::string& text) {
  std::string result;

  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      result += text[i];
      continue;
    }
    const char c = text[++i];
    if (c == 'x' && i + 2 < text.size()) {
      result += static_cast<char>(hex_value(text[i + 1]) * 16 + hex_value(text[i + 2]));
      i += 2;
    } else {
      result += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
    }
  }

  return result;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : name_(path.filename().string()) {
    std::istringstream lines(read_file(path));
    for (std::string line; std::getline(lines, line); ++number_) read_line(line);
  }

  std::vector<RecordedMessage> messages;

 private:
  void read_line(const std::string& line) {
    if (line.starts_with("C>S\t") || line.starts_with("S>C\t")) {
      const std::size_t text = line.find('\t', 4) + 1;
      add(line[0] == 'S', clients_[""], unescaped(line.substr(text)));
      return;
    }
    static const std::regex scripted(R"(^\s*[\d.]+ (\S+) (>>|<<) (.*)$)");
    std::smatch parts;
    if (!std::regex_match(line, parts, scripted)) return;
    Client& client = clients_[parts[1]];
    client.name = parts[1];
    if (parts[2] == ">>") {
      const std::string literal = parts[3];
      if (literal.size() >= 2) add(false, client, unescaped(literal.substr(1, literal.size() - 2)));
    } else {
      read_received(parts[3], client);
    }
  }

  // "[37188 27] b'...'": the number before the bracket is the true length.
  void read_received(const std::string& text, Client& client) {
    const std::size_t bracket = text.find(']');
    const std::size_t blank = text.rfind(' ', bracket);
    const std::size_t from = blank == std::string::npos || blank > bracket ? 1 : blank + 1;
    const auto length = static_cast<std::size_t>(std::atoi(text.c_str() + from));
    if (bracket == std::string::npos || text.size() < bracket + 5) return;
    std::string bytes = unescaped(text.substr(bracket + 4, text.size() - bracket - 5));
    if (bytes.size() != length || bytes.back() != '\0') return;
    bytes.pop_back();
    add(true, client, bytes);
  }

  // Gets role and version of a client from its connection request. A reconnected player has its
  // first version, or version 3 if it never connected before.
  void note_request(const std::string& text, Client& client) const {
    if (text.starts_with("(dispinit")) {
      become(client, Role::kMonitor, version_in(text, 1) >= 3 ? 999 : 1);
    } else if (text.starts_with("(init ")) {
      become(client, Role::kUnknown, version_in(text, 3));
      client.team = text.substr(6, text.find(' ', 6) - 6);
    } else if (text.starts_with("(reconnect ")) {
      const auto known = versions_.find(text.substr(11, text.find(')') - 11));
      become(client, Role::kPlayer, known == versions_.end() ? 3 : known->second);
    }
  }

  void note_reply(const std::string& text, Client& client) {
    if (text == "(init ok)") {
      client.role = Role::kTrainer;
    } else if (text == "(init l ok)" || text == "(init r ok)") {
      client.role = Role::kOnlineCoach;
    } else if (text.starts_with("(init ")) {
      client.role = Role::kPlayer;
      versions_[client.team + " " + text.substr(8, text.find(' ', 8) - 8)] = client.version;
    }
  }

  void add(bool from_server, Client& client, const std::string& text) {
    if (from_server && (text.empty() || text[0] != '(' || text.find('\0') != std::string::npos)) {
      return;
    }
    if (from_server) {
      note_reply(text, client);
    } else {
      note_request(text, client);
    }
    messages.push_back({from_server, client.role, client.version, client.name, text,
                        name_ + ":" + std::to_string(number_)});
  }

  std::string name_;
  int number_ = 1;
  std::map<std::string, Client> clients_;
  std::map<std::string, int> versions_;  ///< of "TEAM UNUM"
};

}  // namespace

std::vector<RecordedMessage> read_transcript(const std::filesystem::path& path) {
  return Reader(path).messages;
}

}  // namespace cls::tests
