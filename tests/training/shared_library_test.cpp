// libcls_training.so: what it exports and what it needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <dlfcn.h>

#include <cstdint>
#include <sstream>
#include <string>

#include "tests/support/command.h"
#include "training/c_api/cls_training.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kLibrary = std::string(CLS_BUILD_DIR) + "/lib/libcls_training.so";

TEST(TrainingLibrary, PlaysFromAnotherProgram) {
  void* library = ::dlopen(kLibrary.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(library, nullptr) << ::dlerror();
  const auto abi = reinterpret_cast<std::int32_t (*)()>(::dlsym(library, "cls_training_abi"));
  ASSERT_NE(abi, nullptr);
  EXPECT_EQ(abi(), CLS_TRAINING_ABI);
  EXPECT_EQ(::dlsym(library, "_ZN3cls8training4PoolC1ENS0_10PoolConfigE"), nullptr);
}

TEST(TrainingLibrary, ExportsOnlyItsInterfaceAndNeedsNoProtobuf) {
  const CommandResult symbols = run({"nm", "-D", "--defined-only", kLibrary});
  if (symbols.exit_code != 0) GTEST_SKIP() << "no nm";
  std::istringstream lines(symbols.out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    EXPECT_THAT(line, HasSubstr(" T cls_training_"));
  }
  EXPECT_EQ(count, 18);
  const CommandResult needs = run({"readelf", "-d", kLibrary});
  ASSERT_EQ(needs.exit_code, 0);
  EXPECT_THAT(needs.out, Not(HasSubstr("protobuf")));
  EXPECT_THAT(needs.out, Not(HasSubstr("grpc")));
  EXPECT_THAT(needs.out, HasSubstr("libsleef"));
}

}  // namespace
}  // namespace cls::tests
