// The house's mechanical rules, held over all sources. Every rule is first shown to fail.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/class_rules.h"
#include "tests/support/name_rules.h"
#include "tests/support/source_rules.h"
#include "tests/support/source_text.h"

using test::Complaints;
using test::Source;

namespace {

namespace fs = std::filesystem;

// What the repository holds, generated and hidden things aside.
const std::vector<Source>& sources() {
  static const std::vector<Source> all = [] {
    std::vector<Source> found;
    const fs::path root = RIND_SOURCE_DIR;
    for (const char* place :
         {"core", "firmware_link", "host", "tests", "tools", "README.md", "ARCHITECTURE.md",
          "CONTRIBUTING.md", "CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json", ".ci"}) {
      std::vector<fs::path> paths;
      if (fs::is_regular_file(root / place)) paths.push_back(root / place);
      if (fs::is_directory(root / place)) {
        for (const auto& entry : fs::recursive_directory_iterator(root / place)) {
          if (entry.is_regular_file()) paths.push_back(entry.path());
        }
      }
      for (const fs::path& path : paths) {
        std::ifstream file(path, std::ios::binary);
        found.push_back({fs::relative(path, root).generic_string(),
                         {std::istreambuf_iterator<char>(file), {}}});
      }
    }
    return found;
  }();
  return all;
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

template <typename Rule>
void hold_everywhere(Rule rule) {
  for (const Source& source : sources()) {
    for (const std::string& complaint : rule(source)) FAIL_CHECK(complaint);
  }
}

// How often a rule complains about a text as if it stood at `path`.
template <typename Rule>
std::size_t complaints(Rule rule, const std::string& path, const std::string& text) {
  return rule(Source{path, text}).size();
}

std::size_t include_complaints(const std::string& path, const std::string& include) {
  return complaints(test::check_includes, path, "#include " + include + "\n");
}

}  // namespace

TEST_CASE("there are sources to look at") {
  CHECK_GT(sources().size(), 50);
  for (const char* expected :
       {"core/units.h", "firmware_link/ports/byte_port.h", "host/formats/layer_source.h",
        "tests/tidy_test.cpp", "CMakeLists.txt"}) {
    CHECK(std::any_of(sources().begin(), sources().end(),
                      [&](const Source& source) { return source.path == expected; }));
  }
}

TEST_CASE("lines of 100 columns, files of 400 lines") {
  CHECK_EQ(complaints(test::check_size, "core/a.h", std::string(100, 'x') + "\n"), 0);
  CHECK_EQ(complaints(test::check_size, "core/a.h", std::string(101, 'x') + "\n"), 1);
  CHECK_EQ(complaints(test::check_size, "core/a.cpp", repeated("…", 100)), 0);
  CHECK_EQ(complaints(test::check_size, "core/a.cpp", repeated("…", 101)), 1);
  CHECK_EQ(complaints(test::check_size, "core/a.cpp", repeated("x\n", 400)), 0);
  CHECK_EQ(complaints(test::check_size, "core/a.cpp", repeated("x\n", 401)), 1);
  hold_everywhere(test::check_size);
}

TEST_CASE("functions of 70 lines") {
  const auto function = [](const std::string& head, int lines, const std::string& line = "  f();") {
    return head + " {\n" + repeated(line + "\n", lines - 2) + "}\n";
  };
  const auto found = [](const std::string& text) {
    return complaints(test::check_functions, "core/a.cpp", "namespace core {\n" + text + "}\n");
  };
  const std::array<std::string, 7> heads = {"void g()",
                                            "bool operator==(const A& a, const B& b)",
                                            "template <typename T>\nT g(T a = T())",
                                            "A::A() : a_{1}, b_(2)",
                                            "TEST_CASE(\"a { b\")",
                                            "int g(int a = 1) noexcept",
                                            "std::string g(char c = '{')"};
  for (const std::string& head : heads) {
    CAPTURE(head);
    const int head_lines = static_cast<int>(std::count(head.begin(), head.end(), '\n'));
    CHECK_EQ(found(function(head, 70 - head_lines)), 0);
    CHECK_EQ(found(function(head, 71 - head_lines)), 1);
  }
  // Methods, with scopes around; braces in strings, comments and characters are none.
  CHECK_EQ(found("class A {\n public:\n" + function("  void g()", 71) + "};\n"), 1);
  CHECK_EQ(found("struct A final : B {\n" + function("  void g()", 70) + "};\n"), 0);
  CHECK_EQ(found(function("void g()", 71, "  f(\"}\", '}', R\"(})\");  // }")), 1);
  CHECK_EQ(found(function("void g()", 71, "  if (a) { f([] { return 1'000; }); }")), 1);
  // Tables, classes and namespaces may be long.
  CHECK_EQ(found("constexpr int kTable[] = {\n" + repeated("  1,\n", 100) + "};\n"), 0);
  CHECK_EQ(found("class A {\n" + repeated("  int b = 0;\n", 100) + "};\n"), 0);
  CHECK_EQ(found(repeated(function("void g()", 30), 5)), 0);
  hold_everywhere(test::check_functions);
}

TEST_CASE("classes of 25 data members") {
  const auto found = [](const std::string& text) {
    return complaints(test::check_members, "core/a.h", text);
  };
  CHECK_EQ(found("struct A {\n" + repeated("  int a = 0;\n", 25) + "};\n"), 0);
  CHECK_EQ(found("struct A {\n" + repeated("  int a = 0;\n", 26) + "};\n"), 1);
  CHECK_EQ(found("class A {\n private:\n" + repeated("  std::map<int, int> a_{};\n", 26) + "};\n"),
           1);
  CHECK_EQ(found("struct A {\n" + repeated("  int a = 0, b = 0;\n", 13) + "};\n"), 1);
  CHECK_EQ(found("struct A {\n" + repeated("  std::function<int(int)> f;\n", 26) + "};\n"), 1);
  // Functions, types and what is nested are none of its members.
  CHECK_EQ(found("struct A {\n" + repeated("  int f() const { return a; }\n", 30) + "};\n"), 0);
  CHECK_EQ(found("struct A {\n" + repeated("  void f(int a);\n", 30) + "};\n"), 0);
  CHECK_EQ(found("struct A {\n" + repeated("  static constexpr int kA = 1;\n", 30) + "};\n"), 0);
  CHECK_EQ(found("struct A {\n  struct B {\n" + repeated("    int a;\n", 20) + "  };\n" +
                 repeated("  int a;\n", 20) + "};\n"),
           0);
  CHECK_EQ(found("enum class A {\n" + repeated("  kA,\n", 30) + "};\n"), 0);
  hold_everywhere(test::check_members);
}

TEST_CASE("functions are seen where they are") {
  const auto functions = test::functions_of(
      "namespace a {\n"
      "#define B(x) {\n"
      "enum class C { kD };\n"
      "struct E {\n"
      "  int f() const { return 1; }\n"
      "  int g = 0;\n"
      "};\n"
      "int h(\n"
      "    int i) {\n"
      "  return i;\n"
      "}\n"
      "}  // namespace a\n");
  REQUIRE_EQ(functions.size(), 2);
  CHECK_EQ(functions[0].first_line, 5);
  CHECK_EQ(functions[0].last_line, 5);
  CHECK_EQ(functions[1].first_line, 8);
  CHECK_EQ(functions[1].last_line, 11);
  // The counter sees about as many as there are.
  std::size_t count = 0;
  for (const Source& source : sources()) {
    if (source.path.ends_with(".cpp")) count += test::functions_of(source.text).size();
  }
  CHECK_GT(count, 200);
}

TEST_CASE("no work is put off, no machine is named") {
  const auto found = [](const std::string& text) {
    return complaints(test::check_words, "README.md", text);
  };
  CHECK_EQ(found("fine\n"), 0);
  CHECK_EQ(found(std::string("a\n// TO") + "DO later\n"), 1);
  CHECK_EQ(found(std::string("FIX") + "ME"), 1);
  CHECK_EQ(found(std::string("XX") + "X"), 1);
  CHECK_EQ(found(std::string("/tmp/XX") + "XXXX"), 0);
  CHECK_EQ(found(std::string("see /wo") + "rk/a"), 1);
  CHECK_EQ(found(std::string("see ../sha") + "red/a"), 1);
  hold_everywhere(test::check_words);
}

TEST_CASE("every header guards itself") {
  CHECK_EQ(complaints(test::check_guard, "core/a.h", "// a\n#pragma once\n"), 0);
  CHECK_EQ(complaints(test::check_guard, "core/a.h", "// #pragma once\n"), 1);
  hold_everywhere(test::check_guard);
}

TEST_CASE("arrows between the rooms") {
  CHECK_EQ(include_complaints("core/a.cpp", "\"core/b.h\""), 0);
  CHECK_EQ(include_complaints("core/a.cpp", "\"firmware_link/b.h\""), 1);
  CHECK_EQ(include_complaints("core/a.cpp", "\"host/b.h\""), 1);
  CHECK_EQ(include_complaints("core/a.cpp", "\"b.h\""), 1);
  CHECK_EQ(include_complaints("firmware_link/a.h", "\"core/b.h\""), 1);
  CHECK_EQ(include_complaints("firmware_link/a.h", "\"firmware_link/b.h\""), 0);
  CHECK_EQ(include_complaints("host/a.cpp", "\"core/b.h\""), 0);
  CHECK_EQ(include_complaints("host/a.cpp", "\"firmware_link/b.h\""), 0);
  CHECK_EQ(include_complaints("host/a.cpp", "\"tests/support/b.h\""), 1);
  CHECK_EQ(include_complaints("host/a.cpp", "\"tools/b.h\""), 1);
  CHECK_EQ(include_complaints("tools/a.cpp", "\"host/b.h\""), 0);
  CHECK_EQ(include_complaints("tools/a.cpp", "\"tests/support/b.h\""), 1);
  CHECK_EQ(include_complaints("tests/a.cpp", "\"tools/b.h\""), 0);
  hold_everywhere(test::check_includes);
}

TEST_CASE("a folder includes only folders below it") {
  const auto found = [](const std::string& path, const std::string& include) {
    return complaints(test::check_floors, path, "#include \"" + include + "\"\n");
  };
  CHECK_EQ(found("core/walls/a.h", "core/offsets/b.h"), 0);
  CHECK_EQ(found("core/walls/a.h", "core/walls/b.h"), 0);
  CHECK_EQ(found("core/walls/a.h", "core/b.h"), 0);
  CHECK_EQ(found("core/offsets/a.cpp", "core/walls/b.h"), 1);
  CHECK_EQ(found("core/a.h", "core/regions/b.h"), 1);
  CHECK_EQ(found("core/cellar/a.h", "core/b.h"), 1);
  CHECK_EQ(found("core/walls/a.h", "core/cellar/b.h"), 1);
  CHECK_EQ(found("firmware_link/session/a.cpp", "firmware_link/dialects/b.h"), 0);
  CHECK_EQ(found("firmware_link/dialects/a.cpp", "firmware_link/session/b.h"), 1);
  CHECK_EQ(found("firmware_link/a.cpp", "firmware_link/wire/b.h"), 1);
  CHECK_EQ(found("host/main.cpp", "host/commands/b.h"), 0);
  CHECK_EQ(found("host/part/a.cpp", "host/printing/b.h"), 1);
  CHECK_EQ(found("host/part/a.cpp", "core/sections/b.h"), 0);
  CHECK_EQ(found("tools/a.cpp", "host/commands/b.h"), 0);
  hold_everywhere(test::check_floors);
}

TEST_CASE("libraries, and what the inner rooms do without") {
  CHECK_EQ(include_complaints("tools/oracles/reference_boolean.cpp", "<boost/polygon/polygon.hpp>"),
           0);
  CHECK_EQ(include_complaints("core/fill.cpp", "<boost/polygon/polygon.hpp>"), 1);
  CHECK_EQ(include_complaints("tools/oracles/reference_boolean.h", "<boost/polygon/polygon.hpp>"),
           1);
  CHECK_EQ(include_complaints("core/a.cpp", "<boost/algorithm/string.hpp>"), 1);
  CHECK_EQ(include_complaints("core/a.cpp", "<fmt/format.h>"), 1);
  CHECK_EQ(include_complaints("host/a.cpp", "<fmt/format.h>"), 0);
  CHECK_EQ(include_complaints("host/a.h", "<fmt/format.h>"), 1);
  CHECK_EQ(include_complaints("host/a.cpp", "<libserialport.h>"), 1);
  CHECK_EQ(include_complaints("host/a.cpp", "<ini.h>"), 1);
  CHECK_EQ(include_complaints("tools/a.cpp", "<CLI/CLI.hpp>"), 0);
  CHECK_EQ(include_complaints("tests/a_test.cpp", "<boost/polygon/polygon.hpp>"), 0);
  CHECK_EQ(include_complaints("host/a.cpp", "<Eigen/Dense>"), 1);
  CHECK_EQ(include_complaints("core/a.cpp", "<vector>"), 0);
  CHECK_EQ(include_complaints("core/a.cpp", "<thread>"), 1);
  CHECK_EQ(include_complaints("core/a.h", "<fstream>"), 1);
  CHECK_EQ(include_complaints("core/a.cpp", "<unistd.h>"), 1);
  CHECK_EQ(include_complaints("firmware_link/session/session.cpp", "<chrono>"), 0);
  CHECK_EQ(include_complaints("firmware_link/session/session.cpp", "<mutex>"), 1);
  CHECK_EQ(include_complaints("firmware_link/session/session.cpp", "<termios.h>"), 1);
  CHECK_EQ(include_complaints("firmware_link/ports/tty_port.cpp", "<termios.h>"), 0);
  CHECK_EQ(include_complaints("host/a.cpp", "<sys/resource.h>"), 0);
}

TEST_CASE("the inner rooms are told the time, and do not print") {
  const std::string asks = "auto t = std::chrono::steady_clock::now();\n";
  CHECK_EQ(complaints(test::check_calls, "core/a.cpp", asks), 1);
  CHECK_EQ(complaints(test::check_calls, "firmware_link/a.h", asks), 1);
  CHECK_EQ(complaints(test::check_calls, "host/a.cpp", asks), 0);
  CHECK_EQ(complaints(test::check_calls, "core/a.cpp", "// " + asks), 0);
  CHECK_EQ(complaints(test::check_calls, "core/a.cpp", "  std::printf(\"x\");\n"), 1);
  CHECK_EQ(complaints(test::check_calls, "core/a.cpp", "  std::snprintf(b, 9, \"x\");\n"), 0);
  CHECK_EQ(complaints(test::check_calls, "core/check.cpp", "  std::fprintf(stderr, s);\n"), 0);
  hold_everywhere(test::check_calls);
}

TEST_CASE("no header is dead") {
  const Source used{"core/a.h", "#pragma once\n"}, own{"core/b.h", "#include \"core/b.h\"\n"};
  const Source user{"core/a.cpp", "#include \"core/a.h\"\n"};
  CHECK_EQ(test::check_dead_headers({used, user}).size(), 0);
  CHECK_EQ(test::check_dead_headers({used, own, user}).size(), 1);
  CHECK_EQ(test::check_dead_headers({used}).size(), 1);
  for (const std::string& complaint : test::check_dead_headers(sources())) FAIL_CHECK(complaint);
}

TEST_CASE("what comments name exists") {
  const auto found = [](const std::string& comment) {
    const Source one{"core/regions/a.h", "int f();\nconstexpr int kOne = 1;\n// " + comment + "\n"};
    return test::check_named_in_comments({one, Source{"core/b.cpp", "// \n"}}).size();
  };
  CHECK_EQ(found("see a.h, regions/a.h and core/b.cpp."), 0);
  CHECK_EQ(found("see c.h"), 1);
  CHECK_EQ(found("see walls/a.h"), 1);
  CHECK_EQ(found("f() does, up to kOne"), 0);
  CHECK_EQ(found("g() does"), 1);
  CHECK_EQ(found("up to kTwo"), 1);
  CHECK_EQ(found("5 km, K2, k"), 0);
  for (const std::string& complaint : test::check_named_in_comments(sources())) {
    FAIL_CHECK(complaint);
  }
}
