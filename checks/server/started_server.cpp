// Folder, ports, process.
#include "checks/server/started_server.h"

#include <utility>

#include "checks/checked_program.h"

namespace cls::checks {

using base::Result;

match::ServerPorts StartedServer::ports() const {
  return {reserved_[0].number(), reserved_[1].number(), reserved_[2].number()};
}

Result<StartedServer> StartedServer::start(const match::ServerChoice& choice,
                                           const std::string& own_program,
                                           const soccer::ServerParams& params,
                                           const std::filesystem::path& folder) {
  StartedServer server;
  match::ServerSetup setup;
  if (choice.kind == match::ServerChoice::Kind::kEmbedded) {
    setup.program = {own_program, "server"};
  } else {
    TRY_INIT(const auto program, process::find_program(choice.program));
    setup.program = {program.string()};
  }

  TRY_INIT(server.reserved_, process::ReservedPort::choose(3));
  setup.folder = folder;
  setup.ports = server.ports();
  setup.server = params;

  TRY_INIT(auto host, process::ProcessHost::create());
  server.host_ = std::make_unique<process::ProcessHost>(std::move(host));

  auto child = server.host_->start(
      server_plan(setup),
      [output = server.output_](std::string_view line) { output->read_line(line); });
  if (!child) return child.error();
  server.child_ = *std::move(child);
  return server;
}

}  // namespace cls::checks
