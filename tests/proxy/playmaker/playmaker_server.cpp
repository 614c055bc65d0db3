// Default replies, and the listening server.
#include "tests/proxy/playmaker/playmaker_server.h"

#include <chrono>
#include <stdexcept>

namespace cls::tests {

std::vector<std::string> GameService::calls() const {
  const std::lock_guard lock(mutex_);
  return calls_;
}

grpc::Status GameService::note(const char* method, int agent) {
  const std::lock_guard lock(mutex_);
  calls_.push_back(std::string(method) + " " + std::to_string(agent));
  return grpc::Status::OK;
}

grpc::Status GameService::Register(grpc::ServerContext*, const protos::RegisterRequest* request,
                                   protos::RegisterResponse* response) {
  note("Register", request->uniform_number());
  if (on_register) return on_register(*request, *response);
  response->set_client_id(++last_client_id_);
  response->set_agent_type(request->agent_type());
  response->set_team_name(request->team_name());
  response->set_uniform_number(request->uniform_number());
  return grpc::Status::OK;
}

grpc::Status GameService::SendServerParams(grpc::ServerContext*, const protos::ServerParam* request,
                                           protos::Empty*) {
  return note("SendServerParams", request->register_response().uniform_number());
}

grpc::Status GameService::SendPlayerParams(grpc::ServerContext*, const protos::PlayerParam* request,
                                           protos::Empty*) {
  return note("SendPlayerParams", request->register_response().uniform_number());
}

grpc::Status GameService::SendPlayerType(grpc::ServerContext*, const protos::PlayerType* request,
                                         protos::Empty*) {
  return note("SendPlayerType", request->register_response().uniform_number());
}

grpc::Status GameService::SendInitMessage(grpc::ServerContext*, const protos::InitMessage* request,
                                          protos::Empty*) {
  return note("SendInitMessage", request->register_response().uniform_number());
}

grpc::Status GameService::GetPlayerActions(grpc::ServerContext*, const protos::State* request,
                                           protos::PlayerActions* response) {
  note("GetPlayerActions", request->register_response().uniform_number());
  return on_player ? on_player(*request, *response) : grpc::Status::OK;
}

grpc::Status GameService::GetCoachActions(grpc::ServerContext*, const protos::State* request,
                                          protos::CoachActions* response) {
  note("GetCoachActions", request->register_response().uniform_number());
  response->add_actions()->mutable_do_helios_substitute();
  return grpc::Status::OK;
}

grpc::Status GameService::SendByeCommand(grpc::ServerContext*,
                                         const protos::RegisterResponse* request, protos::Empty*) {
  return note("SendByeCommand", request->uniform_number());
}

PlaymakerServer::PlaymakerServer(grpc::Service& service, int port,
                                 std::shared_ptr<grpc::ServerCredentials> credentials) {
  grpc::ServerBuilder builder;
  builder.AddListeningPort("127.0.0.1:" + std::to_string(port), credentials, &port_);
  builder.RegisterService(&service);
  server_ = builder.BuildAndStart();
  if (server_ == nullptr) throw std::runtime_error("no port for the test's Playmaker");
}

PlaymakerServer::PlaymakerServer(grpc::CallbackGenericService& service) {
  grpc::ServerBuilder builder;
  builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
  builder.RegisterCallbackGenericService(&service);
  server_ = builder.BuildAndStart();
  if (server_ == nullptr) throw std::runtime_error("no port for the test's Playmaker");
}

std::shared_ptr<grpc::Channel> PlaymakerServer::in_process_channel() {
  return server_->InProcessChannel(grpc::ChannelArguments());
}

void PlaymakerServer::stop() {
  if (server_ == nullptr) return;
  server_->Shutdown(std::chrono::system_clock::now());
  server_.reset();
}

}  // namespace cls::tests
