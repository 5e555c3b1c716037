#include "host/pipeline/printed_objects.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using host::PrintedObjects;

TEST_CASE("an object is left out from the first layer that geometry has not begun") {
  PrintedObjects objects;
  objects.set_names({"a_1", "a_2", "a_3"});
  CHECK(objects.cancel(2) == 0);
  objects.begin_layer(4);
  CHECK(objects.cancel(0) == 5);
  CHECK(objects.left_out(2, 0));
  CHECK_FALSE(objects.left_out(0, 4));
  CHECK(objects.left_out(0, 5));
  CHECK_FALSE(objects.left_out(1, 100));
  CHECK(objects.is_cancelled(0));
  CHECK_FALSE(objects.is_cancelled(1));
}

TEST_CASE("what is no object, or cancelled already, can't be cancelled") {
  PrintedObjects objects;
  CHECK_FALSE(objects.cancel(0));
  objects.set_names({"a_1", "a_2"});
  CHECK_FALSE(objects.cancel(-1));
  CHECK_FALSE(objects.cancel(2));
  CHECK(objects.cancel(1));
  CHECK_FALSE(objects.cancel(1));
}

TEST_CASE("no more are cancelled than a journal has room for, and it gives them back") {
  PrintedObjects objects, resumed;
  objects.set_names(std::vector<std::string>(100, "a"));
  int cancelled = 0;
  for (int i = 0; i < 100; ++i) cancelled += objects.cancel(i) ? 1 : 0;
  CHECK_EQ(cancelled, static_cast<int>(host::kCancelledObjectsMax));
  resumed.restore(objects.cancelled());
  CHECK(resumed.left_out(cancelled - 1, 0));
  CHECK_FALSE(resumed.is_cancelled(cancelled));
}
