#include "host/printing/request_pipe.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"

using host::RequestPipe;
using host::TypedRequest;
using host::UserRequest;

namespace {

int object_of(const char* line) {
  const std::optional<TypedRequest> request = host::request_of_line(line);
  return request && !request->request ? request->object : 0;
}

}  // namespace

TEST_CASE("a line is a request, or none") {
  CHECK(host::request_of_line("pause")->request == UserRequest::kPause);
  CHECK(host::request_of_line(" resume\r")->request == UserRequest::kResume);
  CHECK(host::request_of_line("stop")->request == UserRequest::kStop);
  CHECK_EQ(object_of("cancel 12"), 12);
  CHECK_EQ(object_of("cancel  3 "), 3);
  for (const char* none : {"", "paus", "pause now", "cancel", "cancel ", "cancel 0", "cancel -1",
                           "cancel 2x", "cancel 99999999999", "M112"}) {
    CAPTURE(none);
    CHECK_FALSE(host::request_of_line(none).has_value());
  }
}

TEST_CASE("requests arrive in order; what is none is skipped, however long") {
  const test::PartFolder folder;
  const std::string journal = folder.file("a.journal");
  const auto pipe = RequestPipe::create(journal);
  REQUIRE(pipe != nullptr);
  CHECK_FALSE(pipe->next().has_value());
  REQUIRE(host::tell_print(journal, "cancel 2").ok());
  REQUIRE(host::tell_print(journal, "nonsense").ok());
  // A line whose end would be a request by itself.
  REQUIRE(host::tell_print(journal, std::string(1'000, ' ') + "stop").ok());
  REQUIRE(host::tell_print(journal, "pause").ok());
  const std::optional<TypedRequest> first = pipe->next();
  REQUIRE(first.has_value());
  CHECK_EQ(first->object, 2);
  const std::optional<TypedRequest> second = pipe->next();
  REQUIRE(second.has_value());
  CHECK(second->request == UserRequest::kPause);
  CHECK_FALSE(pipe->next().has_value());
}

TEST_CASE("nobody is told where no print runs, and what is no pipe is left alone") {
  const test::PartFolder folder;
  const std::string journal = folder.file("a.journal");
  CHECK_FALSE(host::tell_print(journal, "stop").ok());
  {
    const auto pipe = RequestPipe::create(journal);
    CHECK(host::tell_print(journal, "stop").ok());
  }
  CHECK_FALSE(std::filesystem::exists(journal + ".requests"));
  CHECK_FALSE(host::tell_print(journal, "stop").ok());
  // A killed print leaves its pipe, which nobody reads.
  REQUIRE_EQ(::mkfifo((journal + ".requests").c_str(), 0600), 0);
  CHECK_FALSE(host::tell_print(journal, "stop").ok());
  CHECK(RequestPipe::create(journal) != nullptr);
  const std::string own = folder.file("b.journal.requests");
  std::ofstream(own) << "mine";
  CHECK(RequestPipe::create(folder.file("b.journal")) == nullptr);
  CHECK_FALSE(host::tell_print(folder.file("b.journal"), "stop").ok());
  CHECK_EQ(test::content(own), "mine");
  // Nobody reads for long: the writer is told, and does not wait.
  const auto pipe = RequestPipe::create(journal);
  core::Status told;
  for (int i = 0; i < 100'000 && told.ok(); ++i) told = host::tell_print(journal, "pause");
  CHECK_FALSE(told.ok());
}
