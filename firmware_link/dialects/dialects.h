// Which dialect a controller speaks, by what it calls itself.
#pragma once

#include <memory>
#include <string_view>

#include "firmware_link/dialects/dialect.h"  // Dialect

namespace firmware_link {

// By M115's FIRMWARE_NAME. Unknown names get Marlin's, because most others follow it.
[[nodiscard]] std::unique_ptr<Dialect> dialect_for(std::string_view firmware_name);

// Whether the name is known. One that is not may be a known one that was damaged.
[[nodiscard]] bool is_known_firmware(std::string_view firmware_name);

}  // namespace firmware_link
