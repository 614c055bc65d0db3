// Codes of the server's (error ...) and (warning ...) replies.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cls::soccer {

/// Every `(error X)` of rcssserver 19 without a parameter; name() gives X.
enum class ErrorCode : std::uint8_t {
  // connecting
  kIllegalTeamName,
  kIllegalTeamNameOrTooLong,
  kIllegalCommandForm,
  kNoMoreTeam,
  kConflictWithFixedTeamName,
  kNoMorePlayerOrGoalieOrIllegalVersion,
  kUnknownCommand,
  kCannotReconnectWhilePlayOn,
  kNoSuchTeamOrPlayer,
  kRedCardedPlayer,
  kSocketOpenFailed,
  kConnectionFailed,
  kIllegalClientVersion,
  kIllegalCoachNameOrTooLong,
  kNoSuchTeam,
  kAlreadyHaveCoach,
  kTrainerWithoutCoachMode,
  kAlreadyHaveTrainer,
  kNoMoreMonitor,
  kOnlyInitAllowedOnInitPort,
  // players
  kTooManyMoves,
  // coaches
  kOutOfRangePlayerType,
  kInvalidXpmData,
  kIllegalMode,
  kIllegalObjectForm,
  kGoalieAlreadyExists,
  kCouldNotParseSay,
  kCannotSayFreeformWhilePlayOn,
  kSaidTooManyFreeform,
  kSaidTooManyMeta,
  kSaidTooManyInfo,
  kSaidTooManyAdvice,
  kSaidTooManyDefine,
  kSaidTooManyDelete,
  kSaidTooManyRule,
};

/// Every `(warning X)`; name() gives X.
enum class WarningCode : std::uint8_t {
  kMessageNotNullTerminated,
  kMovingToOpponentField,
  kCompressionUnsupported,
  kNoTeamFound,
  kNoSuchPlayer,
  kOnlyBeforeKickOff,
  kInvalidTileLocation,
  kInvalidTileSize,
  kCannotSubstituteWhilePlayOn,
  kCannotSubstituteWhilePenaltyShootouts,
  kNoSubstitutionsLeft,
  kNoLeftOfThatType,
  kMaxOfThatTypeOnField,
  kCannotChangeGoalieWhilePlayOn,
  kCannotChangeGoalieWhilePenaltyTaken,
};

std::string_view name(ErrorCode code);
std::string_view name(WarningCode code);
std::optional<ErrorCode> parse_error_code(std::string_view text);
std::optional<WarningCode> parse_warning_code(std::string_view text);

/// Appends `(error X)` or `(warning X)`.
void format(ErrorCode code, std::string& out);
void format(WarningCode code, std::string& out);

}  // namespace cls::soccer
