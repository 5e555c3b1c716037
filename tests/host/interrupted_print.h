// What tests of interrupted prints have in common: a small part with coarse layers, a journal, a
// port that comes back, another program that resumes.
#pragma once

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

#include "host/printing/journal.h"
#include "tests/host/print_rig.h"
#include "tests/support/laid_roads.h"
#include "tests/support/part_folder.h"

namespace print_test {

[[nodiscard]] inline core::Settings coarse() {
  core::Settings settings;
  settings.layer_height = core::Length::from_mm(0.3);
  settings.wall_thickness = core::Length::from_mm(0.9);
  return settings;
}

[[nodiscard]] inline std::string small_part(const test::PartFolder& folder) {
  return folder.add("part.stl", parts::together({parts::box({5, 5, 0}, 9, 8, 3),
                                                 parts::box({6, 6, 0}, 3, 3, 4)}));
}

[[nodiscard]] inline core::Result<host::Journal> new_journal(const std::string& path) {
  host::JournalHead head;
  head.version = "test";
  return host::Journal::create(path, head);
}

// A lost port comes back as another one to the same controller.
inline void make_pluggable(Rig& rig, double wait_s) {
  rig.options.lost_port_wait_s = wait_s;
  rig.control.reopen = [&rig]() -> std::unique_ptr<firmware_link::BytePort> {
    return std::make_unique<BreakablePort>(*rig.port);
  };
}

// Another program prints the rest on the same controller. Nothing interrupts it.
[[nodiscard]] inline host::PrintOutcome print_rest(Rig& rig, const std::string& part,
                                                   const std::string& journal_path,
                                                   const core::Settings& settings = coarse()) {
  const auto read = host::read_journal(journal_path);
  REQUIRE(read.ok());
  core::Result<host::Journal> journal = host::Journal::reopen(journal_path);
  REQUIRE(journal.ok());
  rig.wire = std::make_unique<BreakablePort>(*rig.port);
  rig.print_plan = open(settings, part);
  rig.control.stop = nullptr;
  rig.control.kept_journal = &journal.value();
  const host::JournalRecord& record = read.value().record;
  rig.options.resumption = host::Resumption{record, true, record.nozzle_z_um};
  host::PrintOutcome outcome = rig.print();
  rig.control.kept_journal = nullptr;
  return outcome;
}

// Whether nothing was laid after the first so many commands.
[[nodiscard]] inline bool laid_nothing_after(const Rig& rig, std::size_t commands) {
  const auto end = rig.executed.begin() + static_cast<std::ptrdiff_t>(commands);
  return test::laid_by(rig.executed).size() == test::laid_by({rig.executed.begin(), end}).size();
}

}  // namespace print_test
