// Letting coaches in, and telling them what happens.
#include "simulator/sessions/coaches.h"

#include <utility>

#include "simulator/senses/coach_view.h"
#include "simulator/sessions/greeting.h"
#include "simulator/world/roster.h"
#include "soccer/commands/connection_request.h"
#include "soccer/messages/hear.h"
#include "soccer/protocol/protocol_version.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;

constexpr int kFirstGoalieChangeVersion = 16;

bool is_spoken(double version) {
  return version >= soccer::kOldestServedVersion && version < soccer::kNewestProtocolVersion + 1;
}

bool has_trainer_mode(const World& world) {
  return world.params().coach || world.params().coach_w_referee;
}

}  // namespace

const CoachSession* Coaches::session(ClientId client) const {
  return sessions_[static_cast<std::size_t>(client - kLeftCoach)].get();
}

std::variant<Admission, ErrorCode> Coaches::admit(const World& world, Door door,
                                                  std::string_view datagram) {
  return door == Door::kOfflineCoach ? admit_trainer(world, datagram)
                                     : admit_coach(world, datagram);
}

std::variant<Admission, ErrorCode> Coaches::admit_coach(const World& world,
                                                        std::string_view datagram) {
  soccer::CoachInit init;
  if (const auto error = soccer::parse(datagram, init)) return *error;
  const Side side = side_called(world, init.team.view());
  if (side == Side::kNeutral) return ErrorCode::kNoSuchTeam;
  const ClientId client = side == Side::kLeft ? kLeftCoach : kRightCoach;
  if (slot(client) != nullptr) return ErrorCode::kAlreadyHaveCoach;
  if (!is_spoken(init.version)) return ErrorCode::kIllegalClientVersion;
  names_[index(side)] = std::move(init.coach_name);
  return Admission{client, static_cast<int>(init.version), false};
}

std::variant<Admission, ErrorCode> Coaches::admit_trainer(const World& world,
                                                          std::string_view datagram) {
  if (!has_trainer_mode(world)) return ErrorCode::kTrainerWithoutCoachMode;
  if (slot(kTrainer) != nullptr) return ErrorCode::kAlreadyHaveTrainer;
  soccer::TrainerInit init;
  if (const auto error = soccer::parse(datagram, init)) return *error;
  if (!is_spoken(init.version)) return ErrorCode::kIllegalClientVersion;
  return Admission{kTrainer, static_cast<int>(init.version), false};
}

CoachSession& Coaches::connect(const World& world, const Admission& admission,
                               std::unique_ptr<soccer::Channel> channel) {
  slot(admission.client) = std::make_unique<CoachSession>();
  CoachSession& coach = *slot(admission.client);
  coach.client = admission.client;
  coach.version = admission.version;
  coach.channel = std::move(channel);
  coach.reply(soccer::CoachInitReply{coach.side()});
  send_parameters(world, coach);
  if (!coach.is_trainer()) send_changed_types(world, coach.side(), coach);
  return coach;
}

void Coaches::disconnect_all() {
  for (auto& coach : sessions_) coach.reset();
}

void Coaches::remove_lost() {
  for (auto& coach : sessions_) {
    if (coach != nullptr && coach->lost) coach.reset();
  }
}

void Coaches::begin_step(const World& world, std::vector<CoachWords>& out) {
  for (auto& coach : sessions_) {
    if (coach != nullptr) coach->begin_step();
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    due_.clear();
    language_[index(side)].begin_step(world, due_);
    for (auto& [said, received] : due_) out.push_back({side, std::move(said), received});
  }
}

void Coaches::end_step(const World& world) {
  const soccer::ServerParams& params = world.params();
  const int game_time = params.nr_normal_halfs * world.rules->half_time;
  if (params.nr_normal_halfs <= 0 || game_time == 0) return;
  if (world.clock.stoppage != 0 || world.clock.time <= 0 || world.clock.time % game_time != 0) {
    return;
  }
  for (CoachLanguage& language : language_) language.award(params);
}

void Coaches::send(CoachSession& coach, const soccer::Hear& words) {
  text_.clear();
  soccer::format(words, coach.listener(), text_);
  coach.send(text_);
}

void Coaches::tell_referee(const soccer::Hear& words) {
  for (auto& coach : sessions_) {
    if (coach != nullptr && (!coach->is_trainer() || coach->ear)) send(*coach, words);
  }
}

void Coaches::tell_said(const World& world, const PlayerSaid& said) {
  const Player& speaker = world.player(said.speaker);
  for (auto& coach : sessions_) {
    if (coach == nullptr || (coach->is_trainer() && !coach->ear)) continue;
    soccer::Hear hear;
    hear.time = world.clock.time;
    hear.sender = soccer::Hear::Sender::kPlayer;
    hear.team = shown_name(world, coach->side(), speaker.side);
    hear.unum = speaker.unum;
    hear.goalie = speaker.goalie;
    hear.text = said.text;
    send(*coach, hear);
  }
}

void Coaches::tell_words(const World& world, const CoachWords& words) {
  soccer::Hear hear;
  hear.time = world.clock.time;
  hear.text = words.said.text;
  if (words.side != Side::kNeutral) {
    hear.sender = words.side == Side::kLeft ? soccer::Hear::Sender::kOnlineCoachLeft
                                            : soccer::Hear::Sender::kOnlineCoachRight;
    if (slot(kTrainer) != nullptr && slot(kTrainer)->ear) send(*slot(kTrainer), hear);
    return;
  }
  hear.sender = soccer::Hear::Sender::kTrainer;
  for (auto& coach : sessions_) {
    if (coach != nullptr && (!coach->is_trainer() || coach->ear)) send(*coach, hear);
  }
}

void Coaches::tell_type(const TypeChanged& change) {
  for (auto& coach : sessions_) {
    if (coach == nullptr || coach->is_trainer()) continue;
    soccer::PlayerTypeChange told{change.unum, std::nullopt};
    if (coach->side() == change.side) told.type = change.type;
    coach->reply(told);
  }
}

void Coaches::tell_goalie(const GoalieAppointed& change) {
  for (auto& coach : sessions_) {
    if (coach == nullptr || coach->is_trainer()) continue;
    if (coach->version < kFirstGoalieChangeVersion) continue;
    coach->reply(soccer::PlayerTypeChange{change.unum, std::nullopt, change.side});
  }
}

void Coaches::send_view(const World& world, CoachSession& coach, bool is_look_reply) {
  coach_view(world, coach.side(), coach.version, is_look_reply, view_);
  text_.clear();
  soccer::format(view_, text_);
  coach.send(text_);
}

void Coaches::send_views(const World& world) {
  for (const ClientId client : {kTrainer, kLeftCoach, kRightCoach}) {
    const auto& coach = slot(client);
    if (coach != nullptr && coach->eye) send_view(world, *coach, false);
  }
}

void Coaches::ask(std::string_view think) {
  for (auto& coach : sessions_) {
    if (coach == nullptr || !coach->eye) continue;
    coach->send(think);
    coach->asked = true;
  }
}

}  // namespace cls::simulator
