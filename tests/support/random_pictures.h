// Pictures for the tests of picture formats.
#pragma once

#include <vector>

#include "host/output/rgba_picture.h"  // RgbaPicture

namespace test {

// Of several sizes: noise, small steps, stretches of one colour, and all of them in turn.
[[nodiscard]] std::vector<host::RgbaPicture> random_pictures(unsigned seed);

}  // namespace test
