// Files of tests: source tree, fixtures/, and the large recorded data beside the checkout.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace cls::tests {

/// Root of the source tree.
std::filesystem::path source_folder();

/// `name` inside fixtures/; always exists in a checkout.
std::filesystem::path fixture(const std::string& name);

/// `name` inside the large data set: the folder that the environment variable CLS_DATA names, else
/// ../shared/data beside the source tree. Nothing when it is absent; then
/// `GTEST_SKIP() << "no data: set CLS_DATA"`.
std::optional<std::filesystem::path> data(const std::string& name);

/// The whole file, uncompressed when it is gzip (the name does not matter). Throws
/// std::runtime_error, which fails the test, when it cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace cls::tests
