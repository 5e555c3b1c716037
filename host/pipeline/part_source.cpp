#include "host/pipeline/part_source.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "core/supports/support_heights.h"  // SupportHeights

namespace host {

PartSource::PartSource(PrintPlan& print_plan, const core::Settings& settings,
                       PipelineSignals& signals, const Stopped& stopped)
    : plan_(print_plan),
      signals_(signals),
      settings_(settings),
      stopped_(stopped),
      intake_(plan_.part, plan_.part_path, settings_, print_plan.on_bad_layer, signals.warnings),
      inside_(settings_, print_plan.spool_folder),
      supports_(settings_, print_plan.spool_folder, stopped) {}

core::Status PartSource::prepare(const std::function<void()>& preheat, LayerWatch& watch) {
  if (!plan_.part.enforced && !core::SupportHeights(settings_).hold_anywhere()) {
    supports_.call_off();
  }
  if (core::Status made = make_spools(); !made.ok()) return made;
  if (plan_.part.read_rest || supports_.wants_all() || inside_.wanted()) preheat();
  if (core::Status read = read_rest(); !read.ok()) return read;
  signals_.layers.store(plan_.turn ? plan_.turn->layers : plan_.part.summary.layers);
  if (plan_.part.summary.nothing_hangs) supports_.call_off();
  if (supports_.wants_all()) {
    core::Status prepared = supports_.prepare(intake_, signals_.preparation, watch);
    if (!prepared.ok() || stopped_()) return prepared;
  }
  if (!inside_.wanted()) return {};
  return inside_.prepare([this] { return next_supported(); }, plan_.threads, stopped_,
                         {signals_.preparation, intake_.layers()});
}

core::Status PartSource::make_spools() {
  if (supports_.wants_all()) {
    core::Status made = supports_.make_spools(signals_.warnings);
    if (!made.ok()) return made;
  }
  return inside_.wanted() ? inside_.make_spools(signals_.warnings) : core::Status();
}

core::Status PartSource::read_rest() {
  if (!plan_.part.read_rest) return {};
  core::Result<PartSummary> summary = plan_.part.read_rest();
  if (!summary.ok()) return summary.error();
  plan_.part.summary = std::move(summary).value();
  plan_.part.read_rest = nullptr;
  for (const std::string& warning : plan_.part.summary.warnings) signals_.warnings.put(warning);
  return {};
}

core::Result<TakenSlice> PartSource::next_supported() {
  return supports_.next_slice(intake_, signals_.warnings);
}

core::Result<TakenSlice> PartSource::next_slice() {
  return inside_.wanted() ? inside_.next_slice() : next_supported();
}

void PartSource::tell(GeometryStatistics& statistics, double sliced_before_s) const {
  const PartCounters used = plan_.part.counters();
  StageClock& clock = statistics.clock;
  const auto add = [&clock](Stage stage, double seconds) {
    clock.set_seconds(stage, clock.seconds(stage) + seconds);
  };
  add(Stage::kRead, used.read_cpu_s);
  add(Stage::kSort, used.sort_cpu_s);
  // The stage's own time has reading and sorting in it.
  clock.set_seconds(Stage::kSlice, sliced_before_s + used.slice_cpu_s);
  add(Stage::kSupport, supports_.seconds());
  clock.set_worst_layer(Stage::kSupport, std::max(clock.worst_layer_ms(Stage::kSupport) * 1e-3,
                                                  supports_.worst_layer_s()));
  statistics.peak_held.triangles =
      std::max(statistics.peak_held.triangles, used.peak_triangles_held);
  statistics.spilled_bytes +=
      used.spilled_bytes + supports_.spooled_bytes() + inside_.spooled_bytes();
  statistics.bad_layers += intake_.bad_layers();
  if (!inside_.wanted()) return;
  for (const Stage stage : {Stage::kOffset, Stage::kWindow}) {
    add(stage, inside_.use().seconds[static_cast<std::size_t>(stage)]);
  }
  statistics.retries.mountains += inside_.offset_retries();
  statistics.retries.booleans += inside_.use().boolean_retries;
}

}  // namespace host
