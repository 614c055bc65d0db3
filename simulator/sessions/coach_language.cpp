// Quotas and delays of coach language messages.
#include "simulator/sessions/coach_language.h"

#include "base/index.h"

namespace cls::simulator {
namespace {

using soccer::ClangKind;
using soccer::ErrorCode;

/// Rules of a kind of message.
struct KindRules {
  ErrorCode quota_error;
  int soccer::ServerParams::*quota;  ///< of a window of play_on; freeform has another limit
  bool in_version_7;
  bool in_version_8;
};

const KindRules& rules_of(ClangKind kind) {
  using soccer::ServerParams;
  static constexpr std::array<KindRules, 7> kRules = {{
      {ErrorCode::kSaidTooManyFreeform, nullptr, true, true},
      {ErrorCode::kSaidTooManyInfo, &ServerParams::clang_info_win, true, false},
      {ErrorCode::kSaidTooManyAdvice, &ServerParams::clang_advice_win, true, false},
      {ErrorCode::kSaidTooManyDefine, &ServerParams::clang_define_win, true, true},
      {ErrorCode::kSaidTooManyMeta, &ServerParams::clang_meta_win, true, false},
      {ErrorCode::kSaidTooManyRule, &ServerParams::clang_rule_win, false, true},
      {ErrorCode::kSaidTooManyDelete, &ServerParams::clang_del_win, false, true},
  }};
  return kRules[base::index(kind)];
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
    const auto max_length = base::index(world.params().say_coach_msg_size);
    if (message.freeform().size() > max_length) return ErrorCode::kCouldNotParseSay;
    if (!is_freeform_time(world)) return ErrorCode::kCannotSayFreeformWhilePlayOn;
    if (freeform_allowed_ >= 0 && freeform_said_ >= freeform_allowed_) {
      return rules_of(message.kind).quota_error;
    }
    ++freeform_said_;
  } else if (world.mode == PlayMode::kPlayOn) {
    int& left = left_[base::index(message.kind)];
    if (left <= 0) return rules_of(message.kind).quota_error;
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
    const KindRules& rules = rules_of(static_cast<ClangKind>(kind));
    left_[kind] = rules.quota == nullptr ? 0 : params.*rules.quota;
  }
}

void CoachLanguage::extend_freeform_quota(const soccer::ServerParams& params) {
  if (freeform_allowed_ > 0) freeform_allowed_ += params.say_coach_cnt_max;
}

bool understands(const soccer::Clang& versions, ClangKind kind) {
  const auto within = [&](int version) {
    return versions.min_version <= version && version <= versions.max_version;
  };

  const KindRules& rules = rules_of(kind);
  return (rules.in_version_7 && within(7)) || (rules.in_version_8 && within(8));
}

}  // namespace cls::simulator
