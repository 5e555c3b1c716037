// Placeholders: any text is filled in or refused with its place, within bounds.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/check.h"
#include "host/settings/gcode_placeholders.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto origin = static_cast<host::GcodeOrigin>(data[0] % 3);
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  std::size_t asked = 0;
  const host::VariableLookup lookup =
      [&asked](std::string_view name,
               std::size_t index) -> core::Result<std::optional<host::Variable>> {
    ++asked;
    if (name.size() % 3 == 0 || index > 4) return std::optional<host::Variable>();
    if (name == "part") return core::Error{core::ErrorCode::kBadSetting, "is a part's"};
    const auto kind = static_cast<host::VariableKind>(name.size() % 2 + index % 2);
    return std::optional(host::Variable{std::string(name) + "7", kind});
  };
  const auto filled = host::fill_placeholders({text}, lookup, origin);
  RIND_CHECK(asked <= 2 * size);
  if (!filled.ok()) {
    RIND_CHECK(!filled.error().message.empty());
    return 0;
  }
  std::size_t bytes = 0;
  for (const std::string& line : filled.value()) {
    RIND_CHECK(!line.empty() && line.find_first_of("\n;") == std::string::npos);
    bytes += line.size();
  }
  RIND_CHECK(bytes <= host::kExpandedBytesMax);
  return 0;
}
