// The text or shape of a `log` action.
#pragma once

#include "proto/playmaker.pb.h"

namespace cls::proxy {

/// Calls `use` with the member that is set; false when none is.
template <typename Use>
bool visit_member(const protos::Log& log, Use&& use) {
#define CLS_MEMBER(field, member) \
  case protos::Log::field:        \
    return use(log.member()), true
  switch (log.log_case()) {
    CLS_MEMBER(kAddText, add_text);
    CLS_MEMBER(kAddPoint, add_point);
    CLS_MEMBER(kAddLine, add_line);
    CLS_MEMBER(kAddArc, add_arc);
    CLS_MEMBER(kAddCircle, add_circle);
    CLS_MEMBER(kAddTriangle, add_triangle);
    CLS_MEMBER(kAddRectangle, add_rectangle);
    CLS_MEMBER(kAddSector, add_sector);
    CLS_MEMBER(kAddMessage, add_message);
    case protos::Log::LOG_NOT_SET:
      break;
  }
#undef CLS_MEMBER

  return false;
}

}  // namespace cls::proxy
