// Classifying gRPC status codes.
#include "proxy/playmaker/rpc_status.h"

#include <fmt/format.h>

#include "proto/status_name.h"

namespace cls::proxy {
namespace {

RpcOutcome outcome_of(proto::Rpc rpc, int code) {
  switch (code) {
    case proto::kStatusOk:
      return RpcOutcome::kOk;
    case proto::kStatusDeadlineExceeded:
      return RpcOutcome::kDeadline;
    case proto::kStatusUnavailable:
      return RpcOutcome::kUnavailable;
    case proto::kStatusCancelled:
      // A server that stops cancels the calls that it has taken: the next one may register.
      return is_registration(rpc) ? RpcOutcome::kUnavailable : RpcOutcome::kError;
    case proto::kStatusUnimplemented:
      return RpcOutcome::kUnimplemented;
    default:
      return RpcOutcome::kError;
  }
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

}  // namespace

RpcStatus rpc_status(proto::Rpc rpc, int code, std::string_view error) {
  RpcStatus status{outcome_of(rpc, code), code, {}};
  if (!status.ok()) status.message = fmt::format("{}: {}", proto::name(rpc), one_line(error));
  return status;
}

}  // namespace cls::proxy
