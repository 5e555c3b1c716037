// Every bound of the host in one place, with its reason.
#pragma once

#include <cstddef>
#include <cstdint>

namespace host {

// Between geometry and link. 2,048 commands are some 4 to 40 s of printing: enough to bridge a slow
// layer, little enough that the first road leaves while the next slices are being cut.
inline constexpr std::size_t kQueuedCommandsMax = 2'048;
// What these may take in memory.
inline constexpr std::size_t kQueuedBytesMax = std::size_t{512} * 1'024;

// How long one turn of the link's loop waits for an answer. Short, because a command that geometry
// has just put into an empty queue waits as long.
inline constexpr int kLinkWait_ms = 5;

// With nothing to lay and the planner empty for so long, the nozzle leaves the part.
inline constexpr double kUnderrun_s = 0.3;

// How long a paused nozzle stays hot, unless the user says otherwise.
inline constexpr double kPausedHot_s = 600;

// Feed and flow in percent of what was sliced: what a user may ask for, and by which steps. A
// session takes 10 to 500 (Session::set_feed_percent).
inline constexpr int kFeedPercentMin = 10;
inline constexpr int kFeedPercentMax = 300;
inline constexpr int kFeedPercentStep = 10;

// Layers whose mended defects are told by height; further ones are only counted.
inline constexpr std::size_t kDefectHeightsMax = 16;

// Layers that took long to compute and are told one by one; further ones are only counted. And of
// how many it is known that they were counted, so that each is so once.
inline constexpr std::size_t kSlowLayersTold = 16;
inline constexpr std::size_t kSlowLayersKnown = 256;

// Jobs at most, by default, and how many layers more than jobs may be on their way: enough that
// none waits for a slow layer, few enough to be forgotten beside the window.
inline constexpr int kJobsMax = 64;
inline constexpr int kJobsDefaultMax = 4;
inline constexpr int kBatchesAhead = 1;

// Bytes gathered before a write() to an output file.
inline constexpr std::size_t kFileBufferBytes = std::size_t{64} * 1'024;

// Temporary names of outputs at a time: the output, its statistics, and some to spare.
inline constexpr std::size_t kUnfinishedFilesMax = 8;

// Bytes of a file that is there, looked at to see what it holds.
inline constexpr std::size_t kLookBytesMax = 4'096;

// Memory for sorting a mesh: what it gets, and the least it can do with.
inline constexpr std::size_t kSortBytesDefault = std::size_t{8} << 20;
inline constexpr std::size_t kSortBytesMin = std::size_t{64} << 10;

// Triangles that are read before anything is decided about a mesh, and that may be out of order
// without the mesh being sorted: 384 KiB.
inline constexpr std::size_t kReorderTriangles = 8'192;

// A log file, and how many full ones are kept beside it.
inline constexpr std::size_t kLogBytesMax = std::size_t{1} << 20;
inline constexpr std::size_t kLogFilesMax = 2;

// Layers that may grow the memory that is kept, before allocations are counted.
inline constexpr std::int64_t kWarmUpLayers = 50;

// Of progress, a line in the log at most so often.
inline constexpr double kLogPeriod_s = 60;

// Pieces of memory up to the first size may pass --memory-limit, all together by the second.
inline constexpr std::size_t kMemorySmallBytes = 1'024;
inline constexpr std::int64_t kMemoryReserveBytes = std::int64_t{512} * 1'024;

// What a thread has taken or given back without the others' knowing, at most.
inline constexpr std::int64_t kMemoryUnsettledBytes = std::int64_t{8} * 1'024;
static_assert(kJobsMax * kMemoryUnsettledBytes <= kMemoryReserveBytes);

// Warnings that wait to be told; further ones are only counted.
inline constexpr std::size_t kWarningsHeldMax = 16;

// Stretches of height with facets, apart from one another, that are kept track of.
inline constexpr std::size_t kHeightGapsMax = 256;

}  // namespace host
