// PEM files for endpoints.
#include "cli/support/tls_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <utility>

#include "cli/support/exit_code.h"
#include "proxy/playmaker/grpc_target.h"

namespace cls::cli {
namespace {

struct PemFile {
  const char* option;
  const std::string& name;
  std::string& text;
  const char* holds;  ///< what must stand in its BEGIN line
};

int read_pem(const PemFile& file) {
  if (file.name.empty()) return kDone;
  std::ifstream stream(file.name);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream || std::filesystem::is_directory(file.name)) {
    fmt::print(stderr, "cls: {}: {}: cannot be read\n", file.option, file.name);
    return kNoInput;
  }
  const bool fits = text.find("-----BEGIN ") != std::string::npos &&
                    text.find(fmt::format("{}-----", file.holds)) != std::string::npos;
  if (!fits) {
    fmt::print(stderr, "cls: {}: {}: no {} in PEM form\n", file.option, file.name, file.holds);
    return kBadData;
  }
  file.text = text;
  return kDone;
}

}  // namespace

void add_tls_options(CLI::App& command, TlsOptions& options) {
  command
      .add_option("--tls-ca", options.authorities,
                  "PEM file: who vouches for Playmakers at tls:HOST:PORT (the system's)")
      ->envname("CLS_TLS_CA");
  command
      .add_option("--tls-cert", options.certificate,
                  "PEM file: our certificate for Playmakers that ask for one")
      ->envname("CLS_TLS_CERT");
  command.add_option("--tls-key", options.key, "PEM file: the key of our certificate")
      ->envname("CLS_TLS_KEY");
  command
      .add_option("--tls-name", options.server_name,
                  "name that the Playmaker's certificate bears (its host)")
      ->envname("CLS_TLS_NAME");
}

int read_tls_files(orchestration::match::Endpoint& endpoint, const TlsOptions& options) {
  if (endpoint.tls == nullptr) return kDone;
  if (options.certificate.empty() != options.key.empty()) {
    fmt::print(stderr, "cls: --tls-cert and --tls-key go together\n");
    return kUsage;
  }
  auto files = std::make_shared<proxy::TlsFiles>();
  files->server_name = options.server_name;
  for (const PemFile& file :
       {PemFile{"--tls-ca", options.authorities, files->authorities, "CERTIFICATE"},
        PemFile{"--tls-cert", options.certificate, files->certificate, "CERTIFICATE"},
        PemFile{"--tls-key", options.key, files->key, "PRIVATE KEY"}}) {
    if (const int code = read_pem(file); code != kDone) return code;
  }
  endpoint.tls = std::move(files);
  return kDone;
}

}  // namespace cls::cli
