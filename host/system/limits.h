// All bounds of the host, each with its reason.
#pragma once

#include <cstddef>
#include <cstdint>

namespace host {

// Queue between geometry and link. 2,048 commands are about 4 to 40 s of printing: enough to bridge
// a slow layer, few enough that the first road is sent while the next slices are being cut.
inline constexpr std::size_t kQueuedCommandsMax = 2'048;
// Memory that these commands may take.
inline constexpr std::size_t kQueuedBytesMax = std::size_t{512} * 1'024;

// How long one turn of the link's loop waits for an answer. Short, because a command that was just
// put into an empty queue waits as long.
inline constexpr int kLinkWait_ms = 5;

// The nozzle leaves the part if the planner has been empty for this long and no command is there.
inline constexpr double kUnderrun_s = 0.3;

// How long a paused nozzle stays hot, unless the user says otherwise.
inline constexpr double kPausedHot_s = 600;

// Feed and flow that a user may set, in percent of the sliced values, and the step. A session takes
// 10 to 500 (Session::set_feed_percent).
inline constexpr int kFeedPercentMin = 10;
inline constexpr int kFeedPercentMax = 300;
inline constexpr int kFeedPercentStep = 10;

// Layers whose mended defects are listed by height; further ones are only counted.
inline constexpr std::size_t kDefectHeightsMax = 16;

// Places in the air that are told one by one, of each kind; further ones are only counted.
inline constexpr std::size_t kHangingTold = 4;

// Slow layers that are reported one by one; further ones are only counted. kSlowLayersKnown slow
// layers are remembered, so that none is counted twice.
inline constexpr std::size_t kSlowLayersTold = 16;
inline constexpr std::size_t kSlowLayersKnown = 256;

// Upper bound and default bound of --threads, and how many layers more than threads may be in the
// stages at once: enough that no thread waits for a slow layer, few beside the window's memory.
inline constexpr int kThreadsMax = 64;
inline constexpr int kThreadsDefaultMax = 4;
inline constexpr int kBatchesAhead = 1;

// Bytes gathered before a write() to an output file.
inline constexpr std::size_t kFileBufferBytes = std::size_t{64} * 1'024;

// Bytes of a spool that are read or written at once (record_spool.h).
inline constexpr std::size_t kSpoolBufferBytes = std::size_t{64} * 1'024;

// Temporary names of outputs at a time: the output, its statistics, and some to spare.
inline constexpr std::size_t kUnfinishedFilesMax = 8;

// Bytes read from an existing file to see what it holds.
inline constexpr std::size_t kLookBytesMax = 4'096;

// Memory for sorting a mesh: the default and the minimum.
inline constexpr std::size_t kSortBytesDefault = std::size_t{8} << 20;
inline constexpr std::size_t kSortBytesMin = std::size_t{64} << 10;

// The look-ahead: triangles read before anything is decided about a mesh. So many may be out of
// order without the mesh being sorted. 384 KiB.
inline constexpr std::size_t kReorderTriangles = 8'192;

// Size of a log file, and how many full ones are kept beside it.
inline constexpr std::size_t kLogBytesMax = std::size_t{1} << 20;
inline constexpr std::size_t kLogFilesMax = 2;

// The first layers, which fill reusable buffers; allocations are counted after them.
inline constexpr std::int64_t kWarmUpLayers = 50;

// Filament on the spool from which on its end is told: some minutes of printing.
inline constexpr double kSpoolLow_mm = 1'000;

// Least time between two progress lines in the log.
inline constexpr double kLogPeriod_s = 60;

// Small allocations may exceed --memory-limit: each is at most kMemorySmallBytes, all together at
// most kMemoryReserveBytes over the limit.
inline constexpr std::size_t kMemorySmallBytes = 1'024;
inline constexpr std::int64_t kMemoryReserveBytes = std::int64_t{512} * 1'024;

// Bytes that a thread may allocate or free before it adds them to the common count.
inline constexpr std::int64_t kMemoryUnsettledBytes = std::int64_t{8} * 1'024;
static_assert(kThreadsMax * kMemoryUnsettledBytes <= kMemoryReserveBytes);

// Warnings waiting to be shown; further ones are only counted.
inline constexpr std::size_t kWarningsHeldMax = 16;

// Separate intervals of height with facets that a survey keeps.
inline constexpr std::size_t kHeightGapsMax = 256;

}  // namespace host
