// When an action fails, in words.
#pragma once

#include <string_view>

namespace cls::proxy {

/// "ball not kickable": the column "fails when" of docs/actions.md for the action with this field
/// name in PlayerAction. Empty: it never fails, or there is no such action.
std::string_view fails_when(std::string_view action);

}  // namespace cls::proxy
