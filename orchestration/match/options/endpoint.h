// What LEFT and RIGHT mean: the forms in which a user names a side.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "proxy/playmaker/grpc_target.h"

namespace cls::mock_server {
struct Script;
}

namespace cls::orchestration::match {

/// A side of a match as named on the command line.
struct Endpoint {
  enum class Kind {
    kMock,        ///< `mock`, `mock:NAME`, `mock:FILE.json`: the bundled Playmaker, in process
    kAddress,     ///< `HOST:PORT`, `HOST:PORT+step`, `tls:HOST:PORT`: a running Playmaker
    kUnixSocket,  ///< `unix:PATH`: a running Playmaker on a local socket
    kRun,         ///< `run:COMMAND`: a Playmaker that we start
    kTeam,        ///< `team:DIR`: a foreign team that we start; it needs no proxies
  };

  Kind kind = Kind::kMock;
  std::string text;       ///< as the user wrote it
  std::string behaviour;  ///< kMock: name of a built-in behaviour or a script file; empty: default
  /// kMock: the script itself, once it is read; then `behaviour` only names it.
  std::shared_ptr<const mock_server::Script> script;
  std::string host;        ///< kAddress; IPv6 addresses keep their brackets
  int port = 0;            ///< kAddress
  bool port_step = false;  ///< kAddress: player n asks port + n, the coach port + 13
  /// kAddress: null for plain text; `tls:` alone trusts the system's authorities.
  std::shared_ptr<const proxy::TlsFiles> tls;
  std::string path;     ///< kUnixSocket: the socket; kTeam: the folder
  std::string command;  ///< kRun: for /bin/sh, with placeholders (run_command.h)

  /// True for a side whose agents are ours and ask a Playmaker.
  bool has_playmaker() const { return kind != Kind::kTeam; }
  /// True for a side that needs programs started.
  bool starts_programs() const { return kind == Kind::kRun || kind == Kind::kTeam; }
};

/// Reads one side form. The error names the text and lists the forms.
base::Result<Endpoint> parse_endpoint(std::string_view text);

/// Reads the script that a mock side names; nothing to do for other sides. Errors name the file and
/// the line.
base::Result<void> load_script(Endpoint& endpoint);

/// A team name made from the endpoint, allowed by the soccer protocol (letters, digits, - and _,
/// 15 characters at most).
std::string default_team_name(const Endpoint& endpoint);

/// `name` when the protocol allows it as a team name, else an error that says what is wrong.
base::Result<std::string> check_team_name(std::string_view name);

/// The two names a match is played under; equal ones get _l and _r (shortened where needed).
struct TeamNames {
  std::string left;
  std::string right;
};
TeamNames distinct_names(std::string left, std::string right);

}  // namespace cls::orchestration::match
