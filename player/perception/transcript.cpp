// Replays recorded messages through perception.
#include "player/perception/transcript.h"

#include "player/perception/perception.h"
#include "soccer/commands/connection_request.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/protocol/message_kind.h"

namespace cls::player {
namespace {

using base::Result;
using soccer::MessageKind;

class Replay {
 public:
  explicit Replay(const OnDecision& on_decision) : on_decision_(on_decision) {}

  /// Handles a message sent by the player.
  void sent(std::string_view text) {
    soccer::GameRequest request;
    if (!soccer::parse(text, request)) {
      if (const auto* init = std::get_if<soccer::PlayerInit>(&request)) init_ = *init;
      if (const auto* again = std::get_if<soccer::PlayerReconnect>(&request)) reconnect_ = *again;
      return;
    }

    if (undecided_) {
      undecided_ = false;
      update_derived(world_);
      on_decision_(world_);
    }

    commands_.clear();
    soccer::parse_player_commands(text, commands_);
    record_sent_commands(world_, commands_);
  }

  /// Handles a message received by the player.
  Result<void> received(std::string_view text) {
    switch (soccer::message_kind(text)) {
      case MessageKind::kSenseBody:
        undecided_ = true;
        return apply(text, sense_, on_sense_body);
      case MessageKind::kSee:
        return apply(text, see_, on_see);
      case MessageKind::kHear:
        return apply(text, hear_, on_hear);
      case MessageKind::kServerParam:
      case MessageKind::kPlayerParam:
      case MessageKind::kPlayerType:
        return on_parameter_message(world_, text);
      case MessageKind::kReply:
        return reply(text);
      default:
        return {};
    }
  }

  WorldModel&& world() && { return std::move(world_); }

 private:
  template <typename Message>
  Result<void> apply(std::string_view text, Message& message,
                     void (*update)(WorldModel&, const Message&)) {
    Result<void> parsed = soccer::parse(text, message);
    if (parsed) update(world_, message);
    return parsed;
  }

  Result<void> reply(std::string_view text) {
    soccer::ServerReply reply;
    TRY(soccer::parse(text, reply));

    if (const auto* init = std::get_if<soccer::PlayerInitReply>(&reply)) {
      on_init(world_, *init, init_.team, init_.goalie);
    } else if (const auto* back = std::get_if<soccer::ReconnectReply>(&reply)) {
      on_init(world_, {back->side, reconnect_.unum, back->mode}, soccer::TeamName(reconnect_.team),
              world_.goalie);
    } else if (const auto* change = std::get_if<soccer::PlayerTypeChange>(&reply)) {
      on_change_player_type(world_, *change);
    } else if (std::holds_alternative<soccer::OkGaussianSee>(reply)) {
      on_gaussian_see(world_);
    }

    return {};
  }

  const OnDecision& on_decision_;
  WorldModel world_;
  soccer::PlayerInit init_;
  soccer::PlayerReconnect reconnect_;
  bool undecided_ = false;
  std::vector<soccer::PlayerCommand> commands_;
  soccer::SenseBody sense_;
  soccer::See see_;
  soccer::Hear hear_;
};

}  // namespace

TranscriptReplay replay_transcript(std::string_view transcript, const OnDecision& on_decision) {
  Replay replay(on_decision);
  TranscriptReplay result;

  for (std::size_t number = 1; !transcript.empty(); ++number) {
    const std::size_t end = transcript.find('\n');
    std::string_view line = transcript.substr(0, end);
    transcript.remove_prefix(end == std::string_view::npos ? transcript.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;

    const std::size_t first = line.find('\t');
    const std::size_t second = first == std::string_view::npos ? first : line.find('\t', first + 1);
    const bool sent = line.starts_with("C>S\t");
    if (second == std::string_view::npos || (!sent && !line.starts_with("S>C\t"))) {
      result.errors.push_back({number, "not a transcript line"});
      continue;
    }

    const std::string_view message = line.substr(second + 1);
    if (sent) {
      replay.sent(message);
    } else if (const Result<void> applied = replay.received(message); !applied) {
      result.errors.push_back({number, applied.error().message});
    }
  }

  result.world = std::move(replay).world();
  return result;
}

}  // namespace cls::player
