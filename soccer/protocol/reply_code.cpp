// Names of error and warning replies.
#include "soccer/protocol/reply_code.h"

#include "base/index.h"
#include "base/text/enum_names.h"

namespace cls::soccer {
namespace {

constexpr auto kErrors = base::enum_names<ErrorCode>(
    "illegal_teamname", "illegal_teamname_or_too_long_teamname", "illegal_command_form",
    "no_more_team", "conflict_with_fixed_teamname",
    "no_more_player_or_goalie_or_illegal_client_version", "unknown_command",
    "cannot_reconnect_while_playon", "no_such_team_or_player", "red_carded_player",
    "socket_open_failed", "connection_failed", "illegal_client_version",
    "illegal_coachname_or_too_long_coachname", "no_such_team", "already_have_coach",
    "connected_offline_coach_without_coach_mode", "already_have_offline_coach", "no_more_monitor",
    "only_init_allowed_on_init_port", "too_many_moves", "out_of_range_player_type",
    "invalid_xpm_data", "illegal_mode", "illegal_object_form", "goalie_already_exists",
    "could_not_parse_say", "cannot_say_freeform_while_playon", "said_too_many_freeform_messages",
    "said_too_many_meta_messages", "said_too_many_info_messages", "said_too_many_advice_messages",
    "said_too_many_define_messages", "said_too_many_del_messages", "said_too_many_rule_messages");
static_assert(kErrors.texts.size() == base::index(ErrorCode::kSaidTooManyRule) + 1);

constexpr auto kWarnings = base::enum_names<WarningCode>(
    "message_not_null_terminated", "moving_to_opponent_field", "compression_unsupported",
    "no_team_found", "no_such_player", "only_before_kick_off", "invalid_tile_location",
    "invalid_tile_size", "cannot_sub_while_playon", "cannot_sub_while_penalty_shootouts",
    "no_subs_left", "no_left_of_that_type", "max_of_that_type_on_field",
    "cannot_change_goalie_while_playon", "cannot_change_goalie_while_penalty_taken");
static_assert(kWarnings.texts.size() ==
              base::index(WarningCode::kCannotChangeGoalieWhilePenaltyTaken) + 1);

}  // namespace

std::string_view name(ErrorCode code) { return kErrors.name(code); }
std::string_view name(WarningCode code) { return kWarnings.name(code); }

std::optional<ErrorCode> parse_error_code(std::string_view text) { return kErrors.parse(text); }
std::optional<WarningCode> parse_warning_code(std::string_view text) {
  return kWarnings.parse(text);
}

void format(ErrorCode code, std::string& out) {
  out.append("(error ").append(name(code)).push_back(')');
}

void format(WarningCode code, std::string& out) {
  out.append("(warning ").append(name(code)).push_back(')');
}

}  // namespace cls::soccer
