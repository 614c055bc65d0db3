// SIDE arguments: how a user names a side of a match.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "proxy/playmaker/grpc_target.h"
#include "soccer/per_side.h"

namespace cls::mock_server {
struct Script;
}
namespace cls::player {
struct PlannerParameters;
}
namespace cls::training {
struct Policy;
}

namespace cls::match {

/// A parsed SIDE argument.
struct Endpoint {
  enum class Kind {
    kMock,        ///< `mock`, `mock:NAME`, `mock:FILE.json`: the bundled Playmaker, in process.
                  ///< `policy:FILE`, `mock:learned`: for the coach alone; the players follow a
                  ///< policy
    kAddress,     ///< `HOST:PORT`, `HOST:PORT+step`, `tls:HOST:PORT`: a running Playmaker
    kUnixSocket,  ///< `unix:PATH`: a running Playmaker on a local socket
    kRun,         ///< `run:COMMAND`: a Playmaker that cls starts
    kTeam,        ///< `team:DIR`: an external team that cls starts; it needs no cls agents.
                  ///< `mix:AGENTS=team:DIR;...`: one whose agents are those of several, `parts`
    kMixed,       ///< `mix:AGENTS=SIDE;...`: several Playmakers, each for some of the agents;
                  ///< `each:run:COMMAND`: one for each agent
  };

  Kind kind = Kind::kMock;
  std::string text;      ///< as the user wrote it
  std::string behavior;  ///< kMock: name of a built-in behavior or a script file; empty: default
  /// kMock: the script itself, once it is read; then `behavior` only names it.
  std::shared_ptr<const mock_server::Script> script;
  std::string host;        ///< kAddress; IPv6 addresses keep their brackets
  int port = 0;            ///< kAddress
  bool port_step = false;  ///< kAddress: player n connects to port + n, the coach to port + 13
  /// kAddress: null for plain text; `tls:` alone trusts the system CAs.
  std::shared_ptr<const proxy::TlsFiles> tls;
  std::string path;             ///< kUnixSocket: the socket; kTeam: the folder, unless mixed
  std::string command;          ///< kRun: for /bin/sh, with placeholders (run_command.h)
  std::vector<Endpoint> parts;  ///< kMixed: the Playmakers; kTeam: the mixed teams
  std::string label;            ///< of a part: its agents as the user wrote them, "2-5,coach"
  std::vector<int> agents;      ///< of a part: agent numbers (mixed_side.h)
  /// The FILE of `planner:FILE=SIDE`, whose other members are those of SIDE; empty: none.
  std::string planner_file;
  /// The content of `planner_file`, once it is read; null: the defaults.
  std::shared_ptr<const player::PlannerParameters> planner;
  /// kMock: the FILE of `policy:FILE`, or the name of a built-in policy ("learned" of
  /// `mock:learned`); empty: none.
  std::string policy_file;
  std::shared_ptr<const training::Policy> policy;  ///< once it is read

  /// True for a side of cls agents with a Playmaker.
  bool has_playmaker() const { return kind != Kind::kTeam; }
  /// True for one Playmaker that decides for all agents.
  bool has_one_playmaker() const {
    return has_playmaker() && kind != Kind::kMixed && policy_file.empty();
  }
  /// True if `policy_file` is a file, not the name of a built-in policy.
  bool has_policy_file() const;
  /// True for a side for which cls starts programs.
  bool starts_programs() const;
  /// True for a side that needs nothing but `cls` itself: no program, no other host, no file.
  bool is_built_in() const;
};

/// Parses a SIDE. The error quotes the text and lists what is allowed.
base::Result<Endpoint> parse_endpoint(std::string_view text);

/// Reads the files that cls itself needs for a side: scripts of a mock or of mock parts, policies
/// and parameters of the planner. Errors name file and line.
base::Result<void> load_files(Endpoint& endpoint);

/// The first of these files that does not exist; empty: none.
std::string missing_file(const Endpoint& endpoint);

/// A team name from the endpoint, valid in the soccer protocol (letters, digits, - and _, at most
/// 15 characters).
std::string default_team_name(const Endpoint& endpoint);

/// `name` if it is a valid team name, otherwise an error.
base::Result<std::string> check_team_name(std::string_view name);

using TeamNames = soccer::PerSide<std::string>;

/// Both team names, made distinct: equal names get _l and _r (shortened where needed).
TeamNames distinct_names(std::string left, std::string right);

}  // namespace cls::match
