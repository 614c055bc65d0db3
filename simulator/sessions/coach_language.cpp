// Quotas and delays of coach language messages.
#include "simulator/sessions/coach_language.h"

namespace cls::simulator {
namespace {

using soccer::ClangKind;
using soccer::ErrorCode;

ErrorCode quota_error(ClangKind kind) {
  switch (kind) {
    case ClangKind::kFreeform:
      return ErrorCode::kSaidTooManyFreeform;
    case ClangKind::kInfo:
      return ErrorCode::kSaidTooManyInfo;
    case ClangKind::kAdvice:
      return ErrorCode::kSaidTooManyAdvice;
    case ClangKind::kDefine:
      return ErrorCode::kSaidTooManyDefine;
    case ClangKind::kMeta:
      return ErrorCode::kSaidTooManyMeta;
    case ClangKind::kRule:
      return ErrorCode::kSaidTooManyRule;
    case ClangKind::kDelete:
      break;
  }
  return ErrorCode::kSaidTooManyDelete;
}

int window_quota(const soccer::ServerParams& params, ClangKind kind) {
  switch (kind) {
    case ClangKind::kInfo:
      return params.clang_info_win;
    case ClangKind::kAdvice:
      return params.clang_advice_win;
    case ClangKind::kDefine:
      return params.clang_define_win;
    case ClangKind::kMeta:
      return params.clang_meta_win;
    case ClangKind::kRule:
      return params.clang_rule_win;
    case ClangKind::kDelete:
      return params.clang_del_win;
    case ClangKind::kFreeform:
      break;
  }
  return 0;
}

// In play_on, freeform messages are allowed for freeform_send_period cycles per period.
bool is_freeform_time(const World& world) {
  if (world.mode != PlayMode::kPlayOn) return true;

  const soccer::ServerParams& params = world.params();
  const int elapsed = world.clock.time - world.last_play_on;
  // As unsigned, a negative period is a very long one.
  const auto period = static_cast<unsigned>(params.freeform_wait_period);

  return elapsed > params.freeform_wait_period && period != 0 &&
         static_cast<int>(static_cast<unsigned>(elapsed) % period) < params.freeform_send_period;
}

}  // namespace

std::optional<ErrorCode> CoachLanguage::say(const World& world, const soccer::CoachSay& message) {
  if (message.kind == ClangKind::kFreeform) {
    const auto max_length = static_cast<std::size_t>(world.params().say_coach_msg_size);
    if (message.freeform().size() > max_length) return ErrorCode::kCouldNotParseSay;
    if (!is_freeform_time(world)) return ErrorCode::kCannotSayFreeformWhilePlayOn;
    if (freeform_allowed_ >= 0 && freeform_said_ >= freeform_allowed_)
      return quota_error(message.kind);
    ++freeform_said_;
  } else if (world.mode == PlayMode::kPlayOn) {
    int& left = left_[static_cast<std::size_t>(message.kind)];
    if (left <= 0) return quota_error(message.kind);
    --left;
  }

  queue_.push_back({message, world.clock.time});
  return std::nullopt;
}

void CoachLanguage::begin_step(const World& world, std::vector<Message>& out) {
  const soccer::ServerParams& params = world.params();
  const int now = world.clock.time;
  const auto is_due = [&](const Message& message) {
    return world.mode != PlayMode::kPlayOn || now - message.received >= params.clang_mess_delay;
  };

  // clang_mess_per_cycle is a limit by name only: in rcssserver any value but 0 has no effect.
  while (params.clang_mess_per_cycle > 0 && !queue_.empty() && is_due(queue_.front())) {
    out.push_back(std::move(queue_.front()));
    queue_.pop_front();
  }

  if (window_start_ && now - *window_start_ < params.clang_win_size) return;
  window_start_ = now;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    left_[kind] = window_quota(params, static_cast<ClangKind>(kind));
  }
}

void CoachLanguage::extend_freeform_quota(const soccer::ServerParams& params) {
  if (freeform_allowed_ > 0) freeform_allowed_ += params.say_coach_cnt_max;
}

bool understands(const soccer::Clang& versions, ClangKind kind) {
  const auto within = [&](int version) {
    return versions.min_version <= version && version <= versions.max_version;
  };

  switch (kind) {
    case ClangKind::kFreeform:
    case ClangKind::kDefine:
      return within(7) || within(8);
    case ClangKind::kRule:
    case ClangKind::kDelete:
      return within(8);
    default:
      return within(7);
  }
}

}  // namespace cls::simulator
