// Connections of clients: identity, channel, quota and think/done state, first messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "simulator/world/world.h"
#include "soccer/channel.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/server_reply.h"
#include "soccer/protocol/reply_code.h"
#include "soccer/protocol/team_name.h"

namespace cls::simulator {

/// Index of a client: player slots first, then coaches, trainer and monitors.
using ClientId = int;
constexpr ClientId kNoClient = -1;
constexpr ClientId kLeftCoach = soccer::kPlayersOnPitch;
constexpr ClientId kRightCoach = kLeftCoach + 1;
constexpr ClientId kTrainer = kLeftCoach + 2;
constexpr ClientId kFirstMonitor = kTrainer + 1;

constexpr bool is_monitor(ClientId client) { return client >= kFirstMonitor; }
constexpr bool is_player(ClientId client) { return client < soccer::kPlayersOnPitch; }

/// Where connection requests arrive; each is a UDP port of its own on a network
/// (docs/spec/server-protocol.md 1.1).
enum class ListeningPort : std::uint8_t {
  kPlayers,  ///< players and monitors (server::port)
  kTrainers,
  kOnlineCoaches,
  kMonitors,  ///< monitors only
};

/// An accepted connection request. The client receives nothing before
/// MatchServer::complete_handshake.
struct Admission {
  ClientId client = kNoClient;
  int version = 0;
  bool reconnected = false;
  bool binary = false;  ///< its messages have no closing NUL on a network
  /// Its name for its team, where that is not the team's name; see ClientRights::team_name.
  soccer::TeamName own_name = {};
};

/// The rights of the sender of a request, where the server knows whose process it is. With the
/// right to play for one side only, it belongs to that side whatever name it sends.
struct ClientRights {
  bool left = true;   ///< a player or the online coach of the left side
  bool right = true;  ///< of the right side
  bool trainer = true;
  bool monitor = true;
  /// The name of its side, whatever name it sends: the side has programs of several teams. What it
  /// sees names its side as it does itself. Empty: the first client names a side.
  soccer::TeamName team_name = {};

  /// The side that it must play for, or neutral if the name decides.
  Side only_side() const {
    if (left == right) return Side::kNeutral;
    return left ? Side::kLeft : Side::kRight;
  }
  bool may_play_for(Side side) const { return side == Side::kLeft ? left : right; }
};

/// A request beyond the rights of its sender; it is refused with `reply`.
struct Intrusion {
  soccer::ErrorCode reply = soccer::ErrorCode::kNoMoreTeam;
};
using AdmissionResult = std::variant<Admission, soccer::ErrorCode, Intrusion>;

/// The reply to a request that was not admitted.
inline soccer::ErrorCode refusal(const AdmissionResult& result) {
  const auto* intrusion = std::get_if<Intrusion>(&result);
  return intrusion != nullptr ? intrusion->reply : std::get<soccer::ErrorCode>(result);
}

/// Limits what a client may send between two steps, so that a flood uses neither the memory of the
/// server nor the time of other clients. The rest is dropped.
class ReceiveQuota {
 public:
  static constexpr int kMaxDatagrams = 256;
  static constexpr std::size_t kMaxPlayerBytes = 16 << 10;
  /// Tiles of team graphics are long, and a coach sends one command per datagram.
  static constexpr std::size_t kMaxCoachBytes = 128 << 10;

  explicit ReceiveQuota(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  /// Returns false if the datagram exceeds the quota.
  bool consume(std::size_t datagram_bytes) {
    if (datagrams_ == kMaxDatagrams || datagram_bytes > max_bytes_ - bytes_) {
      exceeded_ = true;
      return false;
    }

    ++datagrams_;
    bytes_ += datagram_bytes;
    return true;
  }

  /// True after a datagram that exceeded it, until reset().
  bool exceeded() const { return exceeded_; }

  void reset() {
    datagrams_ = 0;
    bytes_ = 0;
    exceeded_ = false;
  }

 private:
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  int datagrams_ = 0;
  bool exceeded_ = false;
};

struct Connection {
  explicit Connection(std::size_t max_bytes_per_step = ReceiveQuota::kMaxPlayerBytes)
      : quota(max_bytes_per_step) {
    text_.reserve(kReplyCapacity);
  }

  /// Connects an admitted client.
  void open(const Admission& admission, std::unique_ptr<soccer::Channel> to_client) {
    client = admission.client;
    version = admission.version;
    own_name = admission.own_name;
    channel = std::move(to_client);
  }

  ClientId client = kNoClient;
  int version = 0;
  soccer::TeamName own_name;  ///< see Admission::own_name
  std::unique_ptr<soccer::Channel> channel;

  bool sensed = false;      ///< received its senses since the last step
  bool think_sent = false;  ///< received (think) since the last step
  bool done = false;        ///< sent (done) since the last step
  bool lost = false;        ///< disconnected; removed after the next commands
  ReceiveQuota quota;

  void begin_step() {
    sensed = think_sent = done = false;
    quota.reset();
  }

  /// True if the client received (think) and has not sent (done).
  bool is_awaited() const { return think_sent && !done && !lost; }

  /// Sends one message; a failure marks the connection as lost.
  void send(std::string_view message) {
    if (!lost && !channel->send(message)) lost = true;
  }

  /// Highest zlib compression level.
  static constexpr int kMaxCompressionLevel = 9;

  /// Replies to (compression LEVEL) and applies it if the channel can; a negative level turns
  /// compression off.
  void compress(int level) {
    if (!channel->can_compress()) return reply(soccer::WarningCode::kCompressionUnsupported);
    reply(soccer::OkCompression{level});
    channel->compress(level);
  }

  void reply(const soccer::ServerReply& reply) { send_formatted(reply); }
  void reply(soccer::ErrorCode code) { send_formatted(code); }
  void reply(soccer::WarningCode code) { send_formatted(code); }

 private:
  template <typename Message>
  void send_formatted(const Message& message) {
    text_.clear();
    soccer::format(message, text_);
    send(text_);
  }

  static constexpr std::size_t kReplyCapacity = 128;  ///< bytes

  std::string text_;  ///< reused
};

// Messages that follow the reply to an init of any client (docs/spec/server-protocol.md 2.1).

/// First client version that receives changes of the goalie.
constexpr int kFirstGoalieChangeVersion = 16;

/// True if the server supports clients of this version.
bool is_supported_version(double version);

/// Sends server_param, player_param and the player types in the form of the client's version.
void send_parameters(const World& world, Connection& client);

/// Sends the players with a type other than the default; without the type for opponents of `side`.
void send_changed_types(const World& world, Side side, Connection& client);

/// Sends the text of server::coach_msg_file to an online coach, unless it cannot be read or is too
/// long for a message.
void send_coach_file(const World& world, Connection& coach);

}  // namespace cls::simulator
