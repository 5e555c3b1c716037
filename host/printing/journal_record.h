// One record of a journal, and its bytes.
//
//     checkpoint ──── commands ────┬── … ──┬───────────┬─ … ─┬── not sent
//                                 sure   accepted    lines in flight
//
// Commands before `sure` have moved the machine, whatever happens. Those from there to `accepted`
// have been accepted, but their moves may wait in the planner, which a reset empties: as many are
// taken to wait as a planner holds (16 blocks, or what the controller tells). Which of the lines in
// flight have arrived only the controller knows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/limits.h"                    // kSeamsMax
#include "host/gcode/file_place.h"          // kPlaceBytesMax
#include "host/pipeline/checkpoint.h"       // Checkpoint
#include "host/pipeline/printed_objects.h"  // CancelledObject
#include "host/printing/machine_state.h"    // MachineState

namespace host {

// How the print stood when the record was written.
enum class PrintState : std::uint8_t {
  kRunning,
  kStopped,    // by the user, or because its geometry failed: the safe sequence was executed
  kReset,      // the controller said `start`, or halted
  kPortLost,   // the device vanished; the printer may be running or not
  kLinkFault,  // the controller fell silent, refused a command …
};

inline constexpr int kJournalLinesMax = 32;

struct JournalRecord {
  Checkpoint checkpoint;         // of the layer of the command before `sure`
  std::int64_t sure = 0;         // commands of the print, from its first
  std::uint64_t sure_hash = 0;   // of their texts, from the checkpoint on
  std::int64_t accepted = 0;     // REQUIRES: >= sure
  std::int32_t line = 0;         // the controller's number of the last accepted line
  std::int32_t lines_more = 0;   // sent, or about to be, behind it; at most kJournalLinesMax
  std::uint32_t line_kinds = 0;  // bit i: the i-th of these is a command of the print
  MachineState machine;          // after the accepted commands
  std::int64_t nozzle_z_um =
      0;  // the height that the nozzle was sent to: lifted, when it is parked
  PrintState state = PrintState::kRunning;
  core::LayerIndex layers = 0;     // of the part; 0: not known yet
  std::int64_t last_planned = -1;  // the command before which the print paused by itself; -1: none
  std::vector<CancelledObject> cancelled;  // at most kCancelledObjectsMax
  bool height_in_doubt = false;  // the nozzle was on its way to nozzle_z_um, or from there
};

// First kRecordBytes, whatever is in them, with sequence number and checksum; then kSeamBytes for
// each seam, whose number and checksum the first part has. A seam is its x and y, then its
// layers_ago doubled, and 1 more for a hole: 4 bytes each, lowest first. Behind them are the
// objects that were cancelled, 8 bytes each: an object's number in the upper 16 bits, its layer in
// the others. How many there are stands above the seams' number. A ready file has a place in it
// instead of seams (file_place.h); the first part has kFileRecord and its length for their number.
inline constexpr std::size_t kRecordBytes = 512;
inline constexpr std::size_t kSeamBytes = 12;
inline constexpr std::size_t kCancelledBytes = 8;
inline constexpr std::size_t kRecordBytesMax =
    kRecordBytes + core::kSeamsMax * kSeamBytes + kCancelledObjectsMax * kCancelledBytes;
inline constexpr std::uint64_t kFileRecord = std::uint64_t{1} << 32;
inline constexpr int kCancelledShift = 16;  // of their number, above that of the seams
static_assert(core::kSeamsMax < std::size_t{1} << kCancelledShift);
static_assert(kPlaceBytesMax <= core::kSeamsMax * kSeamBytes);
[[nodiscard]] std::string record_bytes(const JournalRecord& record, std::int64_t sequence);

struct SequencedRecord {
  std::int64_t sequence = 0;
  JournalRecord record;
};

// Nothing when the bytes are not a whole record.
[[nodiscard]] std::optional<SequencedRecord> read_record(std::string_view bytes);

}  // namespace host
