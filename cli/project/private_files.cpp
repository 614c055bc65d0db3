// The names that programs give to secrets.
#include "cli/project/private_files.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/io/whole_file.h"

namespace cls::cli {
namespace {

constexpr std::array<std::string_view, 28> kPrivateNames = {
    ".aws",         ".azure",       ".docker",          ".dockercfg",
    ".env",         ".envrc",       ".git-credentials", ".gnupg",
    ".htpasswd",    ".kube",        ".my.cnf",          ".netrc",
    ".npmrc",       ".pgpass",      ".pypirc",          ".s3cfg",
    ".ssh",         ".yarnrc.yml",  "_netrc",           "credentials.json",
    "id_dsa",       "id_ecdsa",     "id_ed25519",       "id_rsa",
    "secrets.json", "secrets.toml", "secrets.yaml",     "secrets.yml"};

constexpr std::array<std::string_view, 7> kPrivateEndings = {".jks", ".kdbx", ".key", ".keystore",
                                                             ".p12", ".pfx",  ".ppk"};

// Of files that show how an .env looks.
constexpr std::array<std::string_view, 4> kSampleEndings = {".example", ".sample", ".template",
                                                            ".dist"};

bool ends_in_any(std::string_view name, const auto& endings) {
  return std::ranges::any_of(endings,
                             [&](std::string_view ending) { return name.ends_with(ending); });
}

// Bundles of certificates are public; packages for HTTPS bring them.
bool has_only_certificates(const std::filesystem::path& file) {
  const std::string text = base::read_file(file).value_or("");
  return text.find("BEGIN CERTIFICATE") != text.npos && text.find("PRIVATE KEY") == text.npos;
}

}  // namespace

bool is_private(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (std::ranges::find(kPrivateNames, name) != kPrivateNames.end()) return true;
  if (name.starts_with(".env.")) return !ends_in_any(name, kSampleEndings);
  if (name.ends_with(".pem")) return !has_only_certificates(path);
  return ends_in_any(name, kPrivateEndings);
}

}  // namespace cls::cli
