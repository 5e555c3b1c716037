#include "host/printing/controls.h"

#include <doctest/doctest.h>

#include <cctype>
#include <string>
#include <utility>

using host::UserRequest;

TEST_CASE("each key has its request, and all keys that the help names have one") {
  const std::pair<char, UserRequest> keys[] = {
      {'p', UserRequest::kPause},  {'r', UserRequest::kResume},   {' ', UserRequest::kToggle},
      {'s', UserRequest::kStop},   {'+', UserRequest::kFeedUp},   {'-', UserRequest::kFeedDown},
      {'>', UserRequest::kFlowUp}, {'<', UserRequest::kFlowDown}, {'?', UserRequest::kHelp},
      {'h', UserRequest::kHelp},   {'x', UserRequest::kObjects}};
  for (const auto& pair : keys) {
    CAPTURE(pair.first);
    CHECK(host::request_of_key(pair.first) == pair.second);
  }
  const std::string help = host::key_help();
  for (std::size_t at = help.find(": ") + 2; at < help.size(); at = help.find(", ", at) + 2) {
    CAPTURE(help.substr(at));
    CHECK(host::request_of_key(help[at]).has_value());
    if (help.find(", ", at) == std::string::npos) break;
  }
  CHECK_FALSE(host::request_of_key('y').has_value());
  CHECK_FALSE(host::request_of_key('P').has_value());
}
