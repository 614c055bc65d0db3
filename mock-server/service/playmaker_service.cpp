// One call of one agent.
#include "mock-server/service/playmaker_service.h"

#include <grpcpp/support/server_callback.h>

#include <utility>

#include "mock-server/service/delayed_reply.h"

namespace cls::mock_server {

using google::protobuf::Message;
using grpc::ByteBuffer;
using proto::Rpc;

PlaymakerService::PlaymakerService(Responder& responder) : responder_(responder) {
  for (int i = 0; i < proto::kAgentRpcs; ++i) {
    // As the generated WithRawCallbackMethod_NAME does for each method.
    MarkMethodRawCallback(
        i, new grpc::internal::CallbackUnaryHandler<ByteBuffer, ByteBuffer>(
               [this, rpc = static_cast<Rpc>(i)](grpc::CallbackServerContext* context,
                                                 const ByteBuffer* request, ByteBuffer* reply) {
                 return handle(rpc, *context, *request, *reply);
               }));
  }
}

grpc::ServerUnaryReactor* PlaymakerService::handle(Rpc rpc, grpc::CallbackServerContext& context,
                                                   const ByteBuffer& request, ByteBuffer& reply) {
  auto workspace = workspaces_.acquire();
  Message& parsed = workspace->create(request_prototype(rpc));
  Message& message = workspace->create(reply_prototype(rpc));
  Response response;
  response.status = parse(request, parsed);
  if (response.status.ok()) response = responder_.respond(rpc, parsed, message);
  if (response.bytes) {
    reply = buffer_of(*response.bytes);
  } else if (response.status.ok() && !response.hangs) {
    response.status = serialize(message, reply);
  }
  workspaces_.release(std::move(workspace));
  return finish(response, context);
}

}  // namespace cls::mock_server
