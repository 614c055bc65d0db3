// PEM files for endpoints.
#include "cli/support/tls_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "base/io/whole_file.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "proxy/playmaker/grpc_target.h"

namespace cls::cli {
namespace {

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
    return print_error(kNoInput, fmt::format("{}: {}: cannot read", file.option, file.name));
  }
  const bool fits = text->find("-----BEGIN ") != std::string::npos &&
                    text->find(fmt::format("{}-----", file.label)) != std::string::npos;
  if (!fits) {
    return print_error(kBadData, fmt::format("{}: {}: contains no {} in PEM format", file.option,
                                             file.name, file.label));
  }
  file.text = *text;
  return kOk;
}

}  // namespace

void add_tls_options(CLI::App& command, TlsOptions& options) {
  command
      .add_option("--tls-ca", options.authorities,
                  "PEM file of CA certificates that verify tls:HOST:PORT (default: system CAs)")
      ->envname("CLS_TLS_CA");
  command
      .add_option("--tls-cert", options.certificate,
                  "PEM file of the client certificate, for Playmakers that require one")
      ->envname("CLS_TLS_CERT");
  command.add_option("--tls-key", options.key, "PEM file of the private key of --tls-cert")
      ->envname("CLS_TLS_KEY");
  command
      .add_option("--tls-name", options.server_name,
                  "expected name in the Playmaker's certificate (default: its host)")
      ->envname("CLS_TLS_NAME");
}

int read_tls_files(orchestration::match::Endpoint& endpoint, const TlsOptions& options) {
  for (auto& part : endpoint.parts) {
    if (const int code = read_tls_files(part, options); code != kOk) return code;
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
    if (const int code = read_pem(file); code != kOk) return code;
  }
  endpoint.tls = std::move(files);
  return kOk;
}

}  // namespace cls::cli
