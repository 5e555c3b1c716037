#include "host/printing/journal_record.h"

#include <bit>
#include <cstring>
#include <memory>
#include <utility>

#include "core/check.h"               // RIND_CHECK
#include "core/limits.h"              // kSeamsMax
#include "host/files/content_hash.h"  // hash_of

namespace host {
namespace {

// Writes 8 bytes a value, lowest first.
class Writer {
 public:
  static constexpr bool kReads = false;

  void whole(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  }
  [[nodiscard]] std::string& bytes() { return bytes_; }

  template <typename Number>
  void number(Number& value) {
    whole(static_cast<std::uint64_t>(value));
  }
  void real(double& value) { whole(std::bit_cast<std::uint64_t>(value)); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  static constexpr bool kReads = true;

  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::uint64_t whole() {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_ + i])) << (8 * i);
    }
    at_ += 8;
    return value;
  }

  template <typename Number>
  void number(Number& value) {
    value = static_cast<Number>(whole());
  }
  void real(double& value) { value = std::bit_cast<double>(whole()); }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

template <typename Stream>
void pass(Stream& stream, std::optional<std::int64_t>& value) {
  bool known = value.has_value();
  std::int64_t number = value.value_or(0);
  stream.number(known);
  stream.number(number);
  if (Stream::kReads && known) value = number;
}

template <typename Stream>
void pass(Stream& stream, core::Length& length) {
  std::int64_t units = length.units();
  stream.number(units);
  if (Stream::kReads) length = core::Length::from_units(units);
}

template <typename Stream>
void pass(Stream& stream, core::MotionState& motions) {
  stream.number(motions.preheated);
  stream.number(motions.started);
  stream.number(motions.retracted);
  stream.number(motions.position_known);
  stream.number(motions.position.x);
  stream.number(motions.position.y);
  bool known = motions.nozzle_z.has_value();
  core::Length height = motions.nozzle_z.value_or(core::Length());
  stream.number(known);
  pass(stream, height);
  if (Stream::kReads && known) motions.nozzle_z = height;
  bool decided = motions.arcs.has_value();
  bool arcs = motions.arcs.value_or(false);
  stream.number(decided);
  stream.number(arcs);
  if (Stream::kReads && decided) motions.arcs = arcs;
  stream.real(motions.fan);
  stream.real(motions.nozzle_celsius);
  stream.real(motions.bed_celsius);
  stream.number(motions.actions);
  stream.real(motions.acceleration_mm_s2);
  pass(stream, motions.highest);
}

// Both ways, so that what is written is what is read.
template <typename Stream>
void pass(Stream& stream, JournalRecord& record) {
  Checkpoint& checkpoint = record.checkpoint;
  stream.number(checkpoint.layer);
  pass(stream, checkpoint.bottom);
  stream.number(checkpoint.commands);
  stream.real(checkpoint.filament_mm);
  pass(stream, checkpoint.motions);
  pass(stream, checkpoint.encoder.x_um);
  pass(stream, checkpoint.encoder.y_um);
  pass(stream, checkpoint.encoder.z_um);
  pass(stream, checkpoint.encoder.f_mm_min);
  stream.real(checkpoint.encoder.filament_rest_10nm);
  stream.number(checkpoint.encoder.flavor);
  stream.number(record.sure);
  stream.number(record.sure_hash);
  stream.number(record.accepted);
  stream.number(record.line);
  stream.number(record.lines_more);
  stream.number(record.line_kinds);
  MachineState& machine = record.machine;
  pass(stream, machine.x_um);
  pass(stream, machine.y_um);
  pass(stream, machine.z_um);
  pass(stream, machine.f_mm_min);
  stream.number(machine.drawn_back_10nm);
  stream.number(machine.highest_laid_um);
  stream.number(machine.nozzle_tenths);
  stream.number(machine.bed_tenths);
  stream.number(machine.fan);
  stream.number(machine.flavor);
  stream.number(machine.acceleration_mm_s2);
  stream.number(machine.pressure_advance_tens_us);
  stream.number(record.nozzle_z_um);
  auto state = static_cast<std::uint8_t>(record.state);
  stream.number(state);
  if (Stream::kReads) record.state = static_cast<PrintState>(state);
  stream.number(record.layers);
  stream.number(record.last_planned);
  stream.number(record.height_in_doubt);
}

constexpr std::size_t kSumBytes = 8;

void write_low(std::uint32_t value, std::string& bytes) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

std::uint32_t read_low(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

// Whole numbers of 8 bytes: the object above, its layer below.
constexpr int kLayerBits = 48;

std::string cancelled_bytes(const std::vector<CancelledObject>& cancelled) {
  RIND_CHECK(cancelled.size() <= kCancelledObjectsMax);
  Writer writer;
  for (const CancelledObject& one : cancelled) {
    writer.whole(static_cast<std::uint64_t>(one.object) << kLayerBits |
                 static_cast<std::uint64_t>(one.from));
  }
  return std::move(writer.bytes());
}

std::vector<CancelledObject> cancelled_in(std::string_view bytes) {
  std::vector<CancelledObject> cancelled;
  Reader reader(bytes);
  for (std::size_t at = 0; at < bytes.size(); at += kCancelledBytes) {
    const std::uint64_t one = reader.whole();
    const std::uint64_t layer = one & ((std::uint64_t{1} << kLayerBits) - 1);
    cancelled.push_back(
        {static_cast<int>(one >> kLayerBits), static_cast<core::LayerIndex>(layer)});
  }
  return cancelled;
}

std::string seam_bytes(const core::SeamMemory& seams) {
  RIND_CHECK(seams.size() <= core::kSeamsMax);
  std::string bytes;
  for (const core::RememberedSeam& seam : seams) {
    write_low(static_cast<std::uint32_t>(seam.at.x), bytes);
    write_low(static_cast<std::uint32_t>(seam.at.y), bytes);
    write_low(static_cast<std::uint32_t>(seam.layers_ago * 2 + (seam.hole ? 1 : 0)), bytes);
  }
  return bytes;
}

core::SeamMemory seams_in(std::string_view bytes) {
  core::SeamMemory seams;
  for (std::size_t at = 0; at < bytes.size(); at += kSeamBytes) {
    const auto x = static_cast<std::int32_t>(read_low(bytes, at));
    const auto y = static_cast<std::int32_t>(read_low(bytes, at + 4));
    const std::uint32_t more = read_low(bytes, at + 8);
    seams.push_back({{x, y}, more % 2 == 1, static_cast<int>(more / 2)});
  }
  return seams;
}

}  // namespace

std::string record_bytes(const JournalRecord& record, std::int64_t sequence) {
  Writer writer;
  writer.number(sequence);
  JournalRecord copy = record;
  pass(writer, copy);
  const Checkpoint& checkpoint = record.checkpoint;
  const std::string more = checkpoint.file
                               ? bytes_of(*checkpoint.file)
                               : seam_bytes(checkpoint.seams) + cancelled_bytes(record.cancelled);
  const std::uint64_t counts = checkpoint.seams.size() | std::uint64_t{record.cancelled.size()}
                                                             << kCancelledShift;
  writer.whole(checkpoint.file ? kFileRecord + more.size() : counts);
  writer.whole(hash_of(more));
  std::string bytes = std::move(writer.bytes());
  RIND_CHECK(bytes.size() <= kRecordBytes - kSumBytes);
  bytes.resize(kRecordBytes - kSumBytes, '\0');
  Writer sum;
  sum.whole(hash_of(bytes));
  return bytes + sum.bytes() + more;
}

std::optional<SequencedRecord> read_record(std::string_view bytes) {
  if (bytes.size() < kRecordBytes) return std::nullopt;
  const std::string_view content = bytes.substr(0, kRecordBytes - kSumBytes);
  Reader sum(bytes.substr(kRecordBytes - kSumBytes));
  if (sum.whole() != hash_of(content)) return std::nullopt;
  Reader reader(content);
  SequencedRecord read;
  reader.number(read.sequence);
  pass(reader, read.record);
  const std::uint64_t count = reader.whole();
  const bool of_file = count >= kFileRecord;
  const std::uint64_t cancelled = of_file ? 0 : count >> kCancelledShift;
  const std::uint64_t seams = count & ((std::uint64_t{1} << kCancelledShift) - 1);
  const std::uint64_t seam_length = seams * kSeamBytes;
  const std::uint64_t length =
      of_file ? count - kFileRecord : seam_length + cancelled * kCancelledBytes;
  if (length > kRecordBytesMax - kRecordBytes) return std::nullopt;
  // A file that was cut short gets zeros for what it lacks when it is opened again.
  std::string more(bytes.substr(kRecordBytes, length));
  more.resize(length, '\0');
  if (reader.whole() != hash_of(more)) return std::nullopt;
  if (!of_file) {
    const std::string_view all = more;
    read.record.checkpoint.seams = seams_in(all.substr(0, seam_length));
    read.record.cancelled = cancelled_in(all.substr(seam_length));
    return read;
  }
  std::optional<FilePlace> place = place_of(more);
  if (!place) return std::nullopt;
  read.record.checkpoint.file = std::make_shared<const FilePlace>(*std::move(place));
  return read;
}

}  // namespace host
