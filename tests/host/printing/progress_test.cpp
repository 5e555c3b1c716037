#include "host/printing/progress.h"

#include <doctest/doctest.h>

using core::Length;

TEST_CASE("a duration reads as hours, minutes and seconds") {
  CHECK_EQ(host::duration_text(0), "0:00:00");
  CHECK_EQ(host::duration_text(59.6), "0:01:00");
  CHECK_EQ(host::duration_text(3'661), "1:01:01");
  CHECK_EQ(host::duration_text(360'000), "100:00:00");
}

TEST_CASE("the progress line tells what is known and nothing else") {
  host::ProgressReport report;
  report.layer = 45;
  report.layers = 180;
  report.height = Length::from_mm(9);
  report.elapsed_s = 65;
  CHECK_EQ(host::progress_line(report), "layer 45/180 | 9.0 mm | 25 % | 0:01:05");
  report.left_s = 195;
  report.filament_mm = 1'234;
  report.nozzle_celsius = 209.6;
  report.nozzle_target_celsius = 210;
  report.bed_celsius = 60;
  report.lines_in_flight = 4;
  report.queue_share = 0.854;
  CHECK_EQ(host::progress_line(report),
           "layer 45/180 | 9.0 mm | 25 % | 0:03:15 left | 1.23 m | nozzle 210/210 C | bed 60 C | "
           "4 in flight | queue 85 %");
}

TEST_CASE("what keeps a print from its layers is told before them") {
  host::ProgressReport report;
  report.layers = 180;
  report.elapsed_s = 28;
  report.state = "heating";
  report.nozzle_celsius = 143;
  report.nozzle_target_celsius = 210;
  CHECK_EQ(host::progress_line(report), "heating | 0:00:28 | nozzle 143/210 C");
  report.nozzle_celsius.reset();
  report.state = "paused";
  report.layer = 45;
  report.height = Length::from_mm(9);
  report.left_s = 195;
  CHECK_EQ(host::progress_line(report), "paused at layer 45/180 | 9.0 mm | 25 % | 0:03:15 left");
}

TEST_CASE("a part of unknown height has no share") {
  CHECK_EQ(host::progress_line({}), "layer 0 | 0.0 mm | 0:00:00");
}
