// PEM files for endpoints.
#include "cli/support/tls_options.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "base/io/whole_file.h"
#include "cli/support/match_option.h"
#include "cli/support/print_error.h"
#include "proxy/playmaker/grpc_target.h"

namespace cls::cli {
namespace {

using match::TlsFileNames;

struct PemFile {
  const char* option;
  const std::string& name;
  std::string& text;
  const char* label;  ///< required in its BEGIN line
};

int read_pem(const PemFile& file) {
  if (file.name.empty()) return kOk;
  const auto text = base::read_file(file.name);
  if (!text) {
    return print_error(kNoInput, "{}: {}: cannot read", file.option, file.name);
  }

  const bool fits = text->find("-----BEGIN ") != std::string::npos &&
                    text->find(fmt::format("{}-----", file.label)) != std::string::npos;
  if (!fits) {
    return print_error(kBadData, "{}: {}: contains no {} in PEM format", file.option, file.name,
                       file.label);
  }

  file.text = *text;
  return kOk;
}

}  // namespace

void add_tls_options(Command& command, TlsFileNames& files) {
  add_match_option(command, "tls_ca", files.authorities);
  add_match_option(command, "tls_cert", files.certificate);
  add_match_option(command, "tls_key", files.key);
  add_match_option(command, "tls_name", files.server_name);
}

int read_tls_files(match::Endpoint& endpoint, const TlsFileNames& options) {
  for (auto& part : endpoint.parts) {
    TRY_STEP(read_tls_files(part, options));
  }
  if (endpoint.tls == nullptr) return kOk;

  if (options.certificate.empty() != options.key.empty()) {
    return print_error(kUsage, "--tls-cert and --tls-key require each other");
  }

  auto files = std::make_shared<proxy::TlsFiles>();
  files->server_name = options.server_name;

  for (const PemFile& file :
       {PemFile{"--tls-ca", options.authorities, files->authorities, "CERTIFICATE"},
        PemFile{"--tls-cert", options.certificate, files->certificate, "CERTIFICATE"},
        PemFile{"--tls-key", options.key, files->key, "PRIVATE KEY"}}) {
    TRY_STEP(read_pem(file));
  }

  endpoint.tls = std::move(files);
  return kOk;
}

}  // namespace cls::cli
