// The program on files as other programs, and people, make them: exit code, volume, layers, words.
#include "tests/support/file_cases.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace {

constexpr double kVolumeShare = 0.005;

void check(const test::TemporaryFolder& folder, const test::FileCase& file) {
  CAPTURE(file.name);
  const std::string path = folder.write(file.name, file.bytes);
  const std::string statistics = folder.path(file.name + ".json");
  const test::ProgramRun run = test::run_program(std::string(RIND_BINARY_DIR) + "/rind plan '" +
                                                 path + "' --stats '" + statistics + "'");
  CAPTURE(run.output);
  for (const std::string& text : file.says) {
    CAPTURE(text);
    CHECK(run.output.find(text) != std::string::npos);
  }
  if (file.volume_mm3 == 0) {
    CHECK_EQ(run.exit_code, 3);
    CHECK(run.output.find(file.name) != std::string::npos);
    return;
  }
  REQUIRE_EQ(run.exit_code, 0);
  std::ifstream in(statistics);
  const nlohmann::json found = nlohmann::json::parse(in);
  const double volume = found.at("solid_mm3").get<double>() + found.at("loose_mm3").get<double>();
  CAPTURE(volume);
  CHECK(std::abs(volume - file.volume_mm3) <= kVolumeShare * file.volume_mm3);
  CHECK_EQ(found.at("layers").get<int>(), file.layers);
}

void check_all(const std::vector<test::FileCase>& files) {
  const test::TemporaryFolder folder;
  CHECK_GT(files.size(), 5);
  for (const test::FileCase& file : files) check(folder, file);
}

}  // namespace

TEST_CASE("OBJ") { check_all(test::obj_cases()); }
TEST_CASE("AMF") { check_all(test::amf_cases()); }
TEST_CASE("STL, as it is written") { check_all(test::stl_cases()); }
TEST_CASE("STL, shapes") { check_all(test::mesh_cases()); }
TEST_CASE("STL, inside out") { check_all(test::inside_out_cases()); }
TEST_CASE("3MF") { check_all(test::threemf_cases()); }
TEST_CASE("3MF with negative parts, modifiers, marks") { check_all(test::threemf_role_cases()); }
TEST_CASE("zip archives") { check_all(test::zip_cases()); }
