// One packet and some lines for each decision.
#include "proxy/agent/debug_client.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "base/index.h"
#include "base/text/number_text.h"
#include "proxy/actions/debug_lines.h"
#include "proxy/agent/debug_view.h"

namespace cls::proxy {
namespace {

constexpr int kMaxPort = 65535;

// The matches that librcsc's agents write to *.dcl: not before the kick-off, not after the end.
bool is_written(soccer::PlayMode mode) {
  return mode != soccer::PlayMode::kBeforeKickOff && mode != soccer::PlayMode::kTimeOver;
}

// The estimates, not rotated for a shoot-out; or the full state that replaces them.
const player::WorldModel& shown_world(const PlayerAgent& agent) {
  const bool exact = agent.options().full_state == FullStateUse::kOverride;
  return exact ? agent.decision_world() : agent.world();
}

// soccerwindow2 drops a packet without the player.
bool is_shown(const player::WorldModel& world) {
  return world.game.time.cycle >= 0 && world.self.position_valid();
}

// The colon before the port; npos: none, as in a plain IPv6 address.
std::size_t port_colon(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const bool bare_ipv6 = colon != text.find(':') && text.find(']') == std::string::npos;
  const bool in_brackets = text.find(']') != std::string::npos && colon < text.find(']');
  return bare_ipv6 || in_brackets ? std::string::npos : colon;
}

}  // namespace

base::Result<void> set_debug_server(DebugOptions& options, const std::string& text) {
  const std::size_t colon = port_colon(text);
  int port = kDebugServerPort;
  if (colon != std::string::npos) {
    const auto number = base::parse_int(text.substr(colon + 1));
    if (!number || *number < 1 || *number > kMaxPort) {
      return base::Error{fmt::format("debug-server '{}': must be HOST:PORT", text)};
    }
    port = *number;
  }

  auto address = base::resolve_udp(base::strip_brackets(text.substr(0, colon)), port);
  if (!address) {
    return base::Error{fmt::format("debug-server '{}': {}", text, address.error().message)};
  }

  options.server = text;
  options.server_address = *address;
  return {};
}

DebugClient::DebugClient(DebugOptions options) : options_(std::move(options)) {
  if (!options_.server_address) return;
  auto socket = base::UdpSocket::open(options_.server_address->family());
  if (socket) {
    socket_ = *std::move(socket);
  } else {
    error_ = socket.error().message;
  }
}

void DebugClient::on_decision(const Decision& decision) {
  Files& files = files_.at(base::index(decision.agent.unum()));
  if (socket_ || !options_.view_folder.empty()) send_view(decision, files);
  if (!options_.log_folder.empty()) write_log(decision, files);
}

void DebugClient::send_view(const Decision& decision, Files& files) {
  const PlayerAgent& agent = decision.agent;
  const player::WorldModel& world = shown_world(agent);
  if (!is_shown(world)) return;
  format_debug_view(world, agent.sent_commands(), decision.reply, options_.levels, text_);
  if (socket_) socket_->send(text_, true, &*options_.server_address);

  const player::GameState& game = world.game;
  if (options_.view_folder.empty() || !is_written(game.mode)) return;
  if (base::FileSink* file = open(files.view, options_.view_folder, ".dcl", agent)) {
    file->write(fmt::format("%% step {}\n%% debug [{}]\n", game.time.cycle, text_));
  }
}

void DebugClient::write_log(const Decision& decision, Files& files) {
  const player::GameTime now = decision.agent.world().game.time;
  const bool in_time = now.cycle >= options_.first_cycle && now.cycle <= options_.last_cycle;
  if (decision.reply == nullptr || !in_time || files.log_bytes > kMaxDebugBytes) return;

  text_.clear();
  for (const auto& action : decision.reply->actions()) {
    if (action.has_debug_client()) {
      append_debug_text(action.debug_client().message(), now, text_);
    } else if (action.has_log() && is_logged(action.log(), options_.levels)) {
      append_debug_action(action.log(), now, text_);
    }
  }
  if (text_.empty()) return;

  base::FileSink* file =
      open(files.log, options_.log_folder, options_.log_extension, decision.agent);
  if (file == nullptr) return;
  files.log_bytes += text_.size();
  if (files.log_bytes > kMaxDebugBytes) text_ += "the rest is omitted\n";
  file->write(text_);
}

base::FileSink* DebugClient::open(std::unique_ptr<base::FileSink>& file, const std::string& folder,
                                  const std::string& extension, const PlayerAgent& agent) {
  if (file != nullptr || !error_.empty()) return file.get();
  const std::string name =
      fmt::format("{}-{}{}", agent.options().team_name.view(), agent.unum(), extension);
  auto created = base::FileSink::create((std::filesystem::path(folder) / name).string());
  if (!created) {
    error_ = created.error().message;
    return nullptr;
  }
  file = *std::move(created);
  return file.get();
}

std::string DebugClient::close() {
  for (Files& files : files_) {
    for (auto* file : {&files.log, &files.view}) {
      if (*file == nullptr) continue;
      const auto closed = (*file)->close();
      if (!closed && error_.empty()) error_ = closed.error().message;
    }
  }
  return error_;
}

}  // namespace cls::proxy
