#define DOCTEST_CONFIG_NO_SHORT_MACRO_NAMES
#include <doctest/doctest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  // Nobody's printer counts (host/presets/printer_file.h).
  setenv("XDG_CONFIG_HOME", "/nonexistent", 1);
  return doctest::Context(argc, argv).run();
}
