// A journal: what is written is what is read, and a cut at any byte costs at most the record that
// was being written.
#include "host/printing/journal.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "host/files/content_hash.h"
#include "tests/support/temporary_folder.h"

namespace {

host::JournalHead some_head() {
  host::JournalHead head;
  head.version = "1.2.3";
  head.part = "/parts/with space \"and\" quotes.stl";
  head.more_parts = {"/parts/other.stl"};
  head.part_title = "with space";
  head.part_hash = 0xfedcba9876543210U;
  head.part_bytes = 123'456'789'012;
  head.settings = {{"layer_height", "0.2"}, {"start_gcode", "G28\\nM83"}};
  head.on_bad_layer = "repair";
  head.on_floating = "stop";
  head.port = "/dev/ttyUSB0";
  head.usb = "1a86:7523, serial 1";
  head.baud = 250'000;
  head.boot = "boot";
  return head;
}

host::JournalRecord record_of(std::mt19937_64& random) {
  const auto any = [&random] { return static_cast<std::int64_t>(random() >> 8); };
  const auto maybe = [&]() -> std::optional<std::int64_t> {
    if (random() % 2 == 0) return std::nullopt;
    return -any();
  };
  host::JournalRecord record;
  record.checkpoint.layer = any();
  record.checkpoint.bottom = core::Length::from_units(any());
  record.checkpoint.commands = any();
  record.checkpoint.filament_mm = static_cast<double>(any()) / 3;
  record.checkpoint.motions = {
      true, random() % 2 == 0, true, false, {-5, 7}, {}, 0.1, 210, 60, 800, {}, {}, {}};
  record.checkpoint.motions.highest = core::Length::from_units(any());
  if (random() % 3 > 0) record.checkpoint.motions.arcs = random() % 2 == 0;
  if (random() % 2 == 0) record.checkpoint.motions.nozzle_z = core::Length::from_units(any());
  record.checkpoint.encoder = {maybe(), maybe(), maybe(), maybe(), -0.25};
  for (std::size_t i = random() % (core::kSeamsMax + 1); i > 0 && random() % 3 > 0; --i) {
    const auto x = static_cast<std::int32_t>(random() >> 33),
               y = static_cast<std::int32_t>(random() >> 34);
    record.checkpoint.seams.push_back(
        {{-x, y}, random() % 2 == 0, static_cast<int>(random() % 50)});
  }
  record.sure = any();
  record.sure_hash = random();
  record.accepted = record.sure + 4;
  record.line = static_cast<std::int32_t>(random() >> 34);
  record.lines_more = 32;
  record.line_kinds = static_cast<std::uint32_t>(random());
  record.machine = {maybe(), maybe(), maybe(), maybe(), any(), any(), 2'100, 600, 255};
  record.machine.flavor = firmware_link::Flavor::kKlipper;
  record.machine.acceleration_mm_s2 = 1'500;
  record.machine.pressure_advance_tens_us = 4'500;
  record.checkpoint.encoder.flavor = firmware_link::Flavor::kRepRapFirmware;
  record.nozzle_z_um = any();
  record.last_planned = any();
  record.checkpoint.motions.actions = 7;
  record.state = static_cast<host::PrintState>(random() % 5);
  for (std::size_t i = random() % (host::kCancelledObjectsMax + 1); i > 0; --i) {
    record.cancelled.push_back({static_cast<int>(random() % core::kObjectsMax),
                                static_cast<core::LayerIndex>(random() >> 17)});
  }
  return record;
}

// By their bytes, which the first test holds to tell all of it.
bool same(const host::JournalRecord& a, const host::JournalRecord& b) {
  return host::record_bytes(a, 0) == host::record_bytes(b, 0);
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a record is read back as it was written") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1'000; ++i) {
    const host::JournalRecord record = record_of(random);
    const std::string bytes = host::record_bytes(record, i);
    const std::size_t seams = record.checkpoint.seams.size();
    const std::size_t cancelled = record.cancelled.size();
    REQUIRE_EQ(bytes.size(),
               host::kRecordBytes + seams * host::kSeamBytes + cancelled * host::kCancelledBytes);
    const auto read = host::read_record(bytes);
    REQUIRE(read.has_value());
    CHECK_EQ(read->sequence, i);
    CHECK_EQ(read->record.checkpoint.seams, record.checkpoint.seams);
    REQUIRE_EQ(read->record.cancelled.size(), cancelled);
    for (std::size_t j = 0; j < cancelled; ++j) {
      CHECK_EQ(read->record.cancelled[j].object, record.cancelled[j].object);
      CHECK_EQ(read->record.cancelled[j].from, record.cancelled[j].from);
    }
    REQUIRE_EQ(host::record_bytes(read->record, i), bytes);
    CHECK_EQ(read->record.checkpoint.layer, record.checkpoint.layer);
    CHECK_EQ(read->record.checkpoint.encoder.z_um, record.checkpoint.encoder.z_um);
    CHECK_EQ(read->record.checkpoint.encoder.filament_rest_10nm, -0.25);
    CHECK_EQ(read->record.checkpoint.motions.position.x, -5);
    CHECK(read->record.checkpoint.motions.arcs == record.checkpoint.motions.arcs);
    CHECK_EQ(read->record.checkpoint.motions.actions, 7);
    CHECK_EQ(read->record.checkpoint.motions.highest, record.checkpoint.motions.highest);
    CHECK_EQ(read->record.machine.highest_laid_um, record.machine.highest_laid_um);
    CHECK_EQ(read->record.last_planned, record.last_planned);
    CHECK_EQ(read->record.sure_hash, record.sure_hash);
    CHECK_EQ(read->record.line_kinds, record.line_kinds);
    CHECK_EQ(read->record.machine.f_mm_min, record.machine.f_mm_min);
    CHECK_EQ(read->record.machine.fan, 255);
    CHECK(read->record.machine.flavor == firmware_link::Flavor::kKlipper);
    CHECK_EQ(read->record.machine.acceleration_mm_s2, 1'500);
    CHECK_EQ(read->record.machine.pressure_advance_tens_us, 4'500);
    CHECK(read->record.checkpoint.encoder.flavor == firmware_link::Flavor::kRepRapFirmware);
    CHECK_EQ(read->record.checkpoint.motions.acceleration_mm_s2, 800);
    CHECK(read->record.state == record.state);
  }
}

TEST_CASE("any damaged byte is noticed") {
  std::mt19937_64 random(2);
  const std::string bytes = host::record_bytes(record_of(random), 7);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    CAPTURE(i);
    CHECK_FALSE(host::read_record(damaged).has_value());
  }
  CHECK_FALSE(host::read_record(bytes.substr(1)).has_value());
  CHECK_FALSE(host::read_record(std::string(host::kRecordBytes, '\0')).has_value());
}

TEST_CASE("after a cut at any byte of any write the last whole record is found") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("print.journal");
  std::mt19937_64 random(3);
  core::Result<host::Journal> created = host::Journal::create(path, some_head());
  REQUIRE(created.ok());
  host::Journal& journal = created.value();
  std::string before = bytes_of(path);
  CHECK_FALSE(host::read_journal_bytes(before, path).ok());

  std::optional<host::JournalRecord> last;
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const host::JournalRecord record = record_of(random);
    if (i % 5 == 4) {
      journal.note_last(record);
    } else {
      journal.note(record, i % 3 == 0);
    }
    REQUIRE(journal.failed().empty());
    const std::string after = bytes_of(path);
    REQUIRE_EQ(after.size(), before.size());
    const auto [from, unused] = std::mismatch(before.begin(), before.end(), after.begin());
    const auto first = static_cast<std::size_t>(from - before.begin());
    const std::size_t begin = first / host::kJournalBlockBytes * host::kJournalBlockBytes;
    std::string cut = before;
    bool new_one = false;
    const std::size_t size = host::record_bytes(record, 0).size();
    for (std::size_t k = 0; k <= size; ++k) {
      if (k > 0) cut[begin + k - 1] = after[begin + k - 1];
      const auto read = host::read_journal_bytes(cut, path);
      CAPTURE(k);
      if (!last && !read.ok()) continue;
      REQUIRE(read.ok());
      const bool is_new = same(read.value().record, record);
      REQUIRE((is_new || (last && same(read.value().record, *last) && !new_one)));
      new_one = new_one || is_new;
    }
    CHECK(new_one);
    CHECK_EQ(cut, after);
    before = after;
    last = record;
  }
  const auto read = host::read_journal(path);
  REQUIRE(read.ok());
  CHECK_EQ(read.value().head.part, some_head().part);
  CHECK_EQ(read.value().head.part_hash, some_head().part_hash);
  CHECK_EQ(read.value().head.part_bytes, some_head().part_bytes);
  CHECK_EQ(read.value().head.baud, 250'000);
  CHECK(read.value().head.settings == some_head().settings);
}

TEST_CASE("a journal is held by one program, taken up behind its newest record, and removed") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("state/rind/print.journal");
  std::mt19937_64 random(4);
  host::JournalRecord last;
  {
    core::Result<host::Journal> journal = host::Journal::create(path, some_head());
    REQUIRE(journal.ok());
    CHECK_FALSE(host::Journal::create(path, some_head()).ok());
    CHECK_FALSE(host::Journal::reopen(path).ok());
    for (int i = 0; i < 7; ++i) journal.value().note(last = record_of(random), false);
  }
  core::Result<host::Journal> again = host::Journal::reopen(path);
  REQUIRE(again.ok());
  REQUIRE(same(host::read_journal(path).value().record, last));
  for (int i = 0; i < 5; ++i) {
    last = record_of(random);
    again.value().note(last, i == 2);
    CHECK(same(host::read_journal(path).value().record, last));
  }
  again.value().remove();
  CHECK_FALSE(host::read_journal(path).ok());
}

TEST_CASE("a journal takes the place of nothing but a useless one of ours") {
  const test::TemporaryFolder folder;
  std::mt19937_64 random(5);
  const auto made = [](const std::string& path, bool sets_aside = false) {
    return host::Journal::create(path, some_head(), sets_aside).ok();
  };
  const std::string other = folder.path("part.stl");
  std::ofstream(other) << "solid part";
  std::filesystem::create_symlink(other, folder.path("link"));
  std::filesystem::create_symlink(folder.path("nowhere"), folder.path("dangling"));
  REQUIRE_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  std::ofstream(folder.path("nothing")).close();
  for (const char* name : {"part.stl", "link", "dangling", "pipe", "nothing", "."}) {
    CAPTURE(name);
    for (const bool sets_aside : {false, true}) CHECK_FALSE(made(folder.path(name), sets_aside));
    CHECK(host::look_at_journal(folder.path(name)).standing == host::JournalStanding::kForeign);
  }
  CHECK_EQ(bytes_of(other), "solid part");
  CHECK_FALSE(std::filesystem::exists(folder.path("nowhere")));

  const std::string path = folder.path("print.journal");
  CHECK(host::look_at_journal(path).standing == host::JournalStanding::kAbsent);
  CHECK(made(path));
  CHECK(host::look_at_journal(path).standing == host::JournalStanding::kEmpty);
  {
    core::Result<host::Journal> journal = host::Journal::create(path, some_head());  // over it
    REQUIRE(journal.ok());
    CHECK(host::look_at_journal(path).standing == host::JournalStanding::kHeld);
    CHECK_FALSE(made(path, true));
    journal.value().note_last(record_of(random));
  }
  CHECK(host::look_at_journal(path).standing == host::JournalStanding::kResumable);
  const std::string cut = bytes_of(path);
  CHECK_FALSE(made(path));
  CHECK_EQ(bytes_of(path), cut);
  CHECK(made(path, true));
  CHECK_EQ(bytes_of(host::set_aside_name(path)), cut);
  // Nothing is left of those that were refused.
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    CHECK_EQ(entry.path().string().find(".partial"), std::string::npos);
  }
  // What has taken its name is not deleted with it.
  core::Result<host::Journal> journal = host::Journal::create(path, some_head());
  REQUIRE(journal.ok());
  std::filesystem::rename(other, path);
  journal.value().remove();
  CHECK_EQ(bytes_of(path), "solid part");
}

TEST_CASE("a journal that is cut short is taken up where it can be, and not damaged further") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("print.journal");
  std::mt19937_64 random(6);
  {
    core::Result<host::Journal> journal = host::Journal::create(path, some_head());
    REQUIRE(journal.ok());
    for (int i = 0; i < 9; ++i) journal.value().note(record_of(random), i % 4 == 0);
  }
  const std::string whole = bytes_of(path);
  const std::size_t head = host::head_bytes(some_head()).size();
  for (std::size_t size = 0; size < whole.size(); size += size < head ? 301 : 37) {
    CAPTURE(size);
    std::ofstream(path, std::ios::binary | std::ios::trunc) << whole.substr(0, size);
    const auto before = host::read_journal(path);
    core::Result<host::Journal> journal = host::Journal::reopen(path);
    REQUIRE_EQ(journal.ok(), before.ok());
    if (!journal.ok()) {
      REQUIRE_EQ(bytes_of(path), whole.substr(0, size));
      continue;
    }
    REQUIRE(same(host::read_journal(path).value().record, before.value().record));
    const host::JournalRecord next = record_of(random);
    journal.value().renumber(next);
    REQUIRE(same(host::read_journal(path).value().record, next));
    REQUIRE_EQ(bytes_of(path).size(), whole.size());
    REQUIRE_EQ(bytes_of(path).substr(0, head), whole.substr(0, head));
  }
}

TEST_CASE("a day of printing syncs no more than is promised") {
  host::SyncPace pace;
  double syncs = 0;
  std::int64_t sure = 0;
  for (double now_s = 0; now_s < 86'400; now_s += 0.01) {
    const bool paused = now_s > 40'000 && now_s < 50'000;
    if (!paused) ++sure;
    if (pace.due(now_s, sure)) ++syncs;
  }
  CHECK_LE(syncs * host::kJournalBlockBytes, host::kJournalDayBytesMax);
  CHECK_GT(syncs, 76'000 / host::kSyncPeriod_s);
  CHECK_LT(syncs, 76'500 / host::kSyncPeriod_s);
}

TEST_CASE("what is no journal is refused") {
  const std::string good = host::head_bytes(some_head());
  CHECK_FALSE(host::read_journal_bytes("", "x").ok());
  CHECK_FALSE(host::read_journal_bytes("solid part", "x").ok());
  for (std::size_t size = 0; size < good.size(); size += 7) {
    CHECK_FALSE(host::read_journal_bytes(good.substr(0, size), "x").ok());
  }
  std::string damaged = good;
  damaged[100] = static_cast<char>(damaged[100] ^ 1);
  const auto read = host::read_journal_bytes(damaged, "x");
  REQUIRE_FALSE(read.ok());
  CHECK_NE(read.error().message.find("damaged"), std::string::npos);
}

TEST_CASE("content is told apart") {
  CHECK_EQ(host::hash_of(""), 0xcbf29ce484222325U);  // the standard's own examples
  CHECK_EQ(host::hash_of("a"), 0xaf63dc4c8601ec8cU);
  CHECK_EQ(host::hash_of("foobar"), 0x85944171f73967e8U);
  const test::TemporaryFolder folder;
  const std::string path = folder.path("part");
  std::ofstream(path) << "foobar";
  const auto content = host::content_of(path);
  REQUIRE(content.ok());
  CHECK_EQ(content.value().hash, 0x85944171f73967e8U);
  CHECK_EQ(content.value().bytes, 6);
}
