// The rules report violations in samples and accept valid code.
#include "tests/architecture/rules.h"

#include <gtest/gtest.h>

namespace cls::tests {
namespace {

TEST(Includes, RejectHigherAndUnrelatedFolders) {
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"soccer/a.h", "proto/playmaker.pb.h"},
           {"base/a.h", "soccer/b.h"},
           {"soccer/a.h", "gamelog/b.h"},
           {"gamelog/rcg/a.cpp", "simulator/b.h"},
           {"simulator/world/a.cpp", "player/world/b.h"},
           {"simulator/a.cpp", "proto/playmaker.pb.h"},
           {"proxy/deep/a.cpp", "simulator/deep/b.h"},
           {"proxy/a.cpp", "mock-server/b.h"},
           {"mock-server/a.cpp", "gamelog/b.h"},
           {"match/a.cpp", "scenario/b.h"},
           {"match/a.cpp", "cli/b.h"},
           {"simulator/world/a.h", "simulator/referee/b.h"},
           {"player/world/a.h", "proxy/agent/b.h"},
           {"player/unknown/a.h", "player/world/b.h"},
           {"cli/a.cpp", "tests/b.h"}}) {
    const auto found = check_includes({from, "// x\n\n#include \"" + to + "\"\n"});
    ASSERT_EQ(found.size(), 1u) << from << " -> " << to;
    EXPECT_EQ(found[0].line, 3);
    EXPECT_EQ(check_includes({from, "#include <" + to + ">\n"}).size(), 1u) << "angle brackets";
  }
}

TEST(Includes, AcceptLowerFolders) {
  EXPECT_EQ(to_text(check_includes({"simulator/a.cpp",
                                    "#include \"simulator/world/world.h\"\n"
                                    "#include \"soccer/side.h\"\n"
                                    "#include \"gamelog/rcg/rcg.h\"\n"
                                    "#include <vector>\n"})),
            "");
  EXPECT_EQ(to_text(check_includes({"cli/match/a.cpp", "#include \"match/match.h\"\n"})), "");
}

TEST(Includes, RejectRelativePaths) {
  EXPECT_EQ(check_includes({"soccer/a.cpp", "#include \"side.h\"\n"}).size(), 1u);
  EXPECT_EQ(check_includes({"soccer/a.cpp", "#include \"../soccer/side.h\"\n"}).size(), 1u);
}

TEST(Includes, RejectUnknownFolders) {
  EXPECT_EQ(check_includes({"helpers/a.cpp", "\n"}).size(), 1u);
}

TEST(ForbiddenHeaders, RejectGrpcAndProtobufInLowerFolders) {
  for (const std::string folder : {"soccer", "gamelog", "simulator"}) {
    EXPECT_EQ(check_forbidden_headers({folder + "/a.cpp", "#include <grpcpp/grpcpp.h>\n"}).size(),
              1u);
    EXPECT_EQ(
        check_forbidden_headers({folder + "/a.h", "#include <google/protobuf/arena.h>\n"}).size(),
        1u);
  }
  EXPECT_EQ(check_forbidden_headers({"proxy/a.cpp", "#include <grpcpp/grpcpp.h>\n"}).size(), 0u);
}

TEST(ForbiddenHeaders, RejectProtobufInSkills) {
  for (const std::string layer : {"formation", "world", "commands", "ball_skills", "planner"}) {
    const std::string path = "player/" + layer + "/a.cpp";
    for (const std::string header : {"proto/playmaker.pb.h", "proxy/messages/state_message.h"}) {
      EXPECT_EQ(check_includes({path, "#include \"" + header + "\"\n"}).size(), 1u) << path;
    }
    EXPECT_EQ(check_forbidden_headers({path, "#include <google/protobuf/message.h>\n"}).size(), 1u)
        << path;
  }
}

TEST(ForbiddenHeaders, AllowClocksThreadsAndSocketsOnlyInServerFiles) {
  for (const std::string header : {"thread", "mutex", "chrono", "atomic", "boost/asio.hpp",
                                   "boost/asio/ip/udp.hpp", "sys/socket.h", "ctime"}) {
    const std::string text = "#include <" + header + ">\n";
    EXPECT_EQ(check_forbidden_headers({"simulator/physics.cpp", text}).size(), 1u) << header;
    EXPECT_EQ(check_forbidden_headers({"simulator/server/udp.cpp", text}).size(), 0u) << header;
    EXPECT_EQ(check_forbidden_headers({"simulator/server_udp.cpp", text}).size(), 0u) << header;
  }
}

TEST(ForbiddenHeaders, AllowHttpInOneFileOnly) {
  for (const std::string header : {"boost/beast/http.hpp", "boost/asio/ip/tcp.hpp"}) {
    const std::string text = "#include <" + header + ">\n";
    EXPECT_EQ(check_forbidden_headers({"viewer/live/live_site.cpp", text}).size(), 1u) << header;
    EXPECT_EQ(check_forbidden_headers({"cli/logs/live_view.cpp", text}).size(), 1u) << header;
    EXPECT_EQ(check_forbidden_headers({"viewer/live/http_server.cpp", text}).size(), 0u) << header;
  }
}

TEST(Determinism, RejectsCMathFunctionsInAllForms) {
  for (const std::string call :
       {"x = std::sin(y);", "x = ::cos(y);", "x = atan2(a, b);", "return -exp (z);",
        "std::hypot(a, b)", "f(std::powf(a, 2))", "log(x)", "(pow(x, 2))"}) {
    const auto found = check_determinism({"simulator/a.cpp", "\n" + call + "\n"});
    ASSERT_EQ(found.size(), 1u) << call;
    EXPECT_EQ(found[0].line, 2);
  }
}

TEST(Determinism, AcceptsReproducibleFunctions) {
  EXPECT_EQ(to_text(check_determinism(
                {"simulator/a.cpp",
                 "x = math::sin(y) + soccer::math::pow(a, b) + std::sqrt(z) + std::floor(z);\n"
                 "// std::sin(x) in a comment\n"
                 "s = \"std::sin(x)\";\n"
                 "logger.log(x); p->exp(x); design(x); std::logic_error(e); v.cos;\n"})),
            "");
  EXPECT_EQ(to_text(check_determinism({"soccer/math.cpp", "double sin(double x);\n"})), "");
  EXPECT_EQ(to_text(check_determinism({"match/a.cpp", "std::log(x);\n"})), "");
}

TEST(Determinism, RejectsRandomnessOfLibraries) {
  for (const std::string code :
       {"std::normal_distribution<double> d;", "std::uniform_int_distribution d(1, 2);",
        "std::random_device device;", "std::shuffle(a, b, c);", "x = std::rand();", "srand(7);"}) {
    for (const std::string folder : {"simulator", "proxy", "mock-server"}) {
      EXPECT_EQ(check_determinism({folder + "/a.cpp", code}).size(), 1u) << code;
    }
  }
}

TEST(Determinism, RejectsClocksAndThreadsInSimulatorWithoutInclude) {
  EXPECT_EQ(check_determinism({"simulator/a.cpp", "std::chrono::seconds(1);"}).size(), 1u);
  EXPECT_EQ(check_determinism({"simulator/server.cpp", "std::chrono::seconds(1);"}).size(), 0u);
}

TEST(Determinism, RejectsSharedFoldersInTests) {
  const std::string code = "auto folder = testing::TempDir();";
  EXPECT_EQ(check_determinism({"tests/proxy/a_test.cpp", code}).size(), 1u);
  EXPECT_EQ(check_determinism({"tests/support/a.cpp", code}).size(), 0u);
}

std::string repeated(const std::string& line, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line;
  return text;
}

TEST(Shape, RejectsLongFilesAndFunctions) {
  EXPECT_EQ(check_shape({"soccer/a.cpp", "// A.\n" + repeated("int x;\n", 799)}).size(), 0u);
  EXPECT_EQ(check_shape({"soccer/a.cpp", "// A.\n" + repeated("int x;\n", 800)}).size(), 1u);
  EXPECT_EQ(check_shape({"cli/main.cpp", "// A.\n" + repeated("int x;\n", 58)}).size(), 0u);
  EXPECT_EQ(check_shape({"cli/main.cpp", "// A.\n" + repeated("int x;\n", 59)}).size(), 1u);
  const auto function = [](int lines) {
    return "// A.\nvoid f() {\n" + repeated("  g();\n", lines - 2) + "}\n";
  };
  EXPECT_EQ(check_shape({"soccer/a.cpp", function(60)}).size(), 0u);
  EXPECT_EQ(check_shape({"soccer/a.cpp", function(61)}).size(), 1u);
}

TEST(Shape, RejectsFilesWithoutPurposeOrWithToDos) {
  EXPECT_EQ(check_shape({"soccer/a.h", "#pragma once\n"}).size(), 1u);
  EXPECT_EQ(check_shape({"soccer/a.h", std::string("// A.\n// TO") + "DO: more\n"}).size(), 1u);
}

TEST(ProcessWrapper, AllowsBoostProcessInOneFileOnly) {
  const std::string text = "#include <boost/process.hpp>\n#include <boost/process/extend.hpp>\n";
  const SourceFile wrapper{"process/child.cpp", text};
  EXPECT_EQ(check_process_wrapper({wrapper}).size(), 0u);
  EXPECT_EQ(check_process_wrapper({wrapper, {"process/b.cpp", text}}).size(), 2u);
  EXPECT_EQ(check_process_wrapper({{"cli/a.cpp", text}}).size(), 2u);
}

}  // namespace
}  // namespace cls::tests
