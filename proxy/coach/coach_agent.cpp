// A coach's part of a cycle.
#include "proxy/coach/coach_agent.h"

#include <cassert>
#include <string_view>
#include <utility>

#include "proxy/coach/global_perception.h"
#include "proxy/perception.h"
#include "proxy/state_message.h"
#include "soccer/overloaded.h"
#include "soccer/protocol/connection_request.h"
#include "soccer/protocol/message_kind.h"

namespace cls::proxy {
namespace {

// "(move (ball) 1 2)" -> "move"
std::string word_of(std::string_view command) {
  const std::size_t end = command.find_first_of(" )");
  return std::string(command.substr(1, end - 1));
}

}  // namespace

CoachAgent::CoachAgent(std::unique_ptr<soccer::Channel> channel, CoachOptions options)
    : channel_(std::move(channel)), options_(options) {}

bool CoachAgent::connect() {
  refusal_.clear();
  datagram_.clear();
  if (is_trainer()) {
    soccer::format(soccer::TrainerInit{static_cast<double>(options_.protocol)}, datagram_);
  } else {
    soccer::CoachInit request;
    request.team = options_.team_name;
    request.version = options_.protocol;
    soccer::format(request, datagram_);
  }
  return channel_->send(datagram_);
}

bool CoachAgent::ready() const {
  return admitted_ && types_known_ > 0 && types_known_ >= world_.parameters->player.player_types;
}

void CoachAgent::perceive() {
  while (!deciding_ && channel_->receive(message_)) take_in(message_);
}

void CoachAgent::take_in(const std::string& message) {
  const auto parsed = [&](auto& out) {
    const soccer::Result<void> result = soccer::parse(message, out);
    if (!result) trouble_.note_unreadable(result.error().message, message);
    return result.ok();
  };
  switch (soccer::message_kind(message)) {
    case soccer::MessageKind::kGlobalView:
      if (!parsed(view_)) break;
      on_global_view(world_, view_);
      if (!world_.server().synch_mode) due_ = true;
      break;
    case soccer::MessageKind::kHear:
      if (!parsed(hear_)) break;
      on_coach_hear(world_, hear_);
      if (hear_.sender == soccer::Hear::Sender::kPlayer && hear_.team == world_.our_team_name) {
        notes_.strength.hear(world_, hear_.unum, hear_.text);
      }
      break;
    case soccer::MessageKind::kServerParam:
    case soccer::MessageKind::kPlayerParam:
    case soccer::MessageKind::kPlayerType: {
      const soccer::Result<void> result = on_parameter_message(world_, message);
      if (!result) trouble_.note_unreadable(result.error().message, message);
      if (result && soccer::message_kind(message) == soccer::MessageKind::kPlayerType) {
        ++types_known_;
      }
      break;
    }
    case soccer::MessageKind::kReply:
      take_in_reply(message);
      break;
    case soccer::MessageKind::kSenseBody:  // for players
    case soccer::MessageKind::kSee:
    case soccer::MessageKind::kFullState:
    case soccer::MessageKind::kUnknown:
      break;
  }
}

void CoachAgent::take_in_reply(const std::string& message) {
  soccer::ServerReply reply;
  if (const soccer::Result<void> result = soccer::parse(message, reply); !result) {
    trouble_.note_unreadable(result.error().message, message);
    return;
  }
  std::visit(
      soccer::Overloaded{
          [this](const soccer::Think&) { due_ = true; },
          [this](const soccer::CoachInitReply& init) {
            on_coach_init(world_, init.side, options_.team_name);
            admitted_ = true;
            send(soccer::Eye{true});
            if (is_trainer()) send(soccer::TrainerEar{true});
          },
          [this](const soccer::PlayerTypeChange& change) { change_type(change); },
          [this](const soccer::OkChangePlayerType& change) {
            // A trainer is told by this alone; what online coaches do is not said to him.
            if (!is_trainer() || !change.type) return;
            auto& types =
                change.team == world_.our_team_name ? world_.our_types : world_.their_types;
            if (change.unum < 1 || change.unum > soccer::kPlayersPerTeam) return;
            types[static_cast<std::size_t>(change.unum - 1)] = *change.type;
          },
          [this](const soccer::OkTeamNames& names) {
            if (!is_trainer()) return;
            world_.our_team_name = names.left;
            world_.their_team_name = names.right;
            names_complete_ = !names.left.empty() && !names.right.empty();
          },
          [this](const soccer::ErrorReply& error) {
            if (!admitted_) refusal_ = error.text;
            trouble_.note_error(error.text);
          },
          [this](const soccer::WarningReply& warning) { trouble_.note_warning(warning.text); },
          [](const auto&) {},
      },
      reply);
}

void CoachAgent::change_type(const soccer::PlayerTypeChange& change) {
  on_change_player_type(world_, change);
  const bool is_number = change.unum >= 1 && change.unum <= soccer::kPlayersPerTeam;
  if (change.goalie_side != soccer::Side::kNeutral || !is_number) return;
  if (change.type) {
    note_own_change(notes_, world_, change.unum, *change.type);
  } else {
    notes_.analysis.forget(change.unum);
  }
}

const protos::State& CoachAgent::state() {
  assert(decision_due());
  deciding_ = true;
  complete_global(world_);
  if (!is_trainer()) {
    take_notes(notes_, world_);
    for (PlayerState& opponent : world_.opponents) {
      const auto i = static_cast<std::size_t>(opponent.unum - 1);
      int& known = world_.their_types[i];
      if (known < 0) known = notes_.analysis.found()[i];
      opponent.type_id = known;
    }
  }
  fill_coach_state(world_, options_.role, state_);
  return state_;
}

void CoachAgent::act(const protos::CoachActions& actions) {
  orders_.clear();
  carry_out(actions, world_, notes_, report_, orders_);
  send_orders();
}

void CoachAgent::act(const protos::TrainerActions& actions) {
  orders_.clear();
  carry_out(actions, world_, report_, orders_);
  send_orders();
}

void CoachAgent::act_without_reply() {
  orders_.clear();
  send_orders();
}

void CoachAgent::send_orders() {
  for (const soccer::CoachCommand& order : orders_) send(order);
  if (is_trainer() && !names_complete_) send(soccer::AskTeamNames{});
  if (world_.server().synch_mode) send(soccer::Done{});
  due_ = deciding_ = false;
}

// The server reads the first command of a datagram only.
void CoachAgent::send(const soccer::CoachCommand& command) {
  datagram_.clear();
  const bool formatted = soccer::format(command, datagram_);
  assert(formatted && "orders hold what the grammar can say");
  channel_->send(datagram_);
  if (!std::holds_alternative<soccer::Done>(command)) ++sent_[word_of(datagram_)];
}

// A trainer has no word for leaving; the server need not wait for one that does not look.
void CoachAgent::leave() {
  if (is_trainer()) {
    send(soccer::Eye{false});
  } else {
    send(soccer::Bye{});
  }
}

}  // namespace cls::proxy
