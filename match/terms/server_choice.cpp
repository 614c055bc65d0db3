// Parses --server and --mode.
#include "match/terms/server_choice.h"

#include <fmt/format.h>

#include "base/system/socket_address.h"
#include "base/text/enum_names.h"
#include "base/text/number_text.h"
#include "base/text/suggestion.h"
#include "match/terms/host_name.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;

constexpr auto kModes = base::enum_names<MatchMode>("lockstep", "synch", "realtime");

// 0: not a port number.
int port_in(std::string_view text) {
  const int port = base::parse_int(text).value_or(0);
  return port >= 1 && port <= 65535 ? port : 0;
}

// HOST:PORT.
Result<void> parse_address(std::string_view text, std::size_t colon, ServerChoice& choice) {
  choice.kind = ServerChoice::Kind::kAddress;
  choice.host = base::strip_brackets(std::string(text.substr(0, colon)));
  choice.port = port_in(text.substr(colon + 1));
  if (choice.host.empty() || choice.port == 0) {
    return Error{fmt::format("--server '{}': must be HOST:PORT with a port from 1 to 65535", text)};
  }
  if (const std::string problem = host_problem(text.substr(0, colon)); !problem.empty()) {
    return Error{fmt::format("--server '{}': {}", text, problem)};
  }
  return {};
}

}  // namespace

Result<ServerChoice> parse_server(std::string_view text) {
  ServerChoice choice;
  choice.text = text;
  if (text == "embedded") return choice;
  if (text.empty()) return Error{"--server '': must be embedded, rcssserver, PATH or HOST:PORT"};
  if (text.find("://") != std::string_view::npos) {
    return Error{fmt::format("--server '{}': {}", text, host_problem(text))};
  }

  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos && text.find('/') == std::string_view::npos) {
    TRY(parse_address(text, colon, choice));
    return choice;
  }

  choice.kind = ServerChoice::Kind::kProgram;
  choice.program = text;
  const std::string_view near = base::nearest_name(text, {"embedded", "rcssserver"});
  if (near != text && !near.empty()) {
    return Error{fmt::format(
        "--server '{}': did you mean '{}'? (embedded, rcssserver, the PATH of a server, or "
        "HOST:PORT)",
        text, near)};
  }
  return choice;
}

std::string_view name(MatchMode mode) { return kModes.name(mode); }

Result<MatchMode> parse_mode(std::string_view text) {
  if (const auto mode = kModes.parse(text)) return *mode;

  const std::string_view near =
      base::nearest_name(text, {kModes.texts.begin(), kModes.texts.end()});
  if (!near.empty()) return Error{fmt::format("--mode '{}': did you mean '{}'?", text, near)};
  return Error{fmt::format("--mode '{}': must be {}", text, fmt::join(kModes.texts, " or "))};
}

}  // namespace cls::match
