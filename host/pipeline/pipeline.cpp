#include "host/pipeline/pipeline.h"

#include <cstddef>
#include <string>
#include <utility>

#include "core/walls/wall_style.h"  // with_style
#include "host/part/object_sequence.h"
#include "host/pipeline/command_stage.h"
#include "host/pipeline/part_pipeline.h"
#include "host/system/stage_clock.h"  // process_cpu_seconds

namespace host {
namespace {

// A part; or objects one after another, each with a pipeline of its own.
class PrintRun {
 public:
  PrintRun(PrintPlan& print_plan, const PipelineOutputs& outputs, PipelineSignals& signals,
           GeometryStatistics& statistics)
      : plan_(print_plan),
        outputs_(outputs),
        signals_(signals),
        statistics_(statistics),
        commands_(core::with_style(print_plan.settings), print_plan.command_form, outputs,
                  refused_) {
    if (plan_.start) commands_.resume_from(*plan_.start);
  }

  [[nodiscard]] core::Result<PipelineEnd> run() {
    core::Result<PipelineEnd> end = plan_.part.sequence ? run_objects() : run_one(plan_);
    if (end.ok() && end.value() == PipelineEnd::kDone && outputs_.on_motion) {
      commands_.finish();
      commands_.tell_missed(plan_.part_path, signals_.warnings);
      if (refused_) end = PipelineEnd::kStopped;
    }
    commands_.tell(statistics_);
    return end;
  }

 private:
  [[nodiscard]] core::Result<PipelineEnd> run_one(PrintPlan& part) {
    return run_part(part, outputs_, signals_, statistics_, commands_, refused_);
  }

  [[nodiscard]] core::Result<PipelineEnd> run_objects() {
    if (core::Status read = read_rest(); !read.ok()) return read.error();
    ObjectSequence& objects = *plan_.part.sequence;
    signals_.layers.store(plan_.part.summary.layers);
    commands_.tell_objects(plan_.part.summary.objects, signals_.objects);
    const std::size_t first = plan_.start ? objects.of_layer(plan_.start->layer) : 0;
    for (std::size_t i = first; i < objects.size(); ++i) {
      const core::LayerIndex before = objects.layers_before(i);
      if (signals_.objects.left_out(static_cast<int>(i), before)) continue;
      core::Result<PrintPlan> object = plan_of(objects, i);
      if (!object.ok()) return object.error();
      if (plan_.start && i == first) {
        object.value().start = plan_.start;
        object.value().start->layer -= before;
      }
      commands_.begin_object(before);
      core::Result<PipelineEnd> end = run_one(object.value());
      if (!end.ok() || end.value() != PipelineEnd::kDone) return end;
      if (i + 1 < objects.size() && outputs_.on_motion) commands_.leave_object();
    }
    return PipelineEnd::kDone;
  }

  // How large each object is decides where it lies.
  [[nodiscard]] core::Status read_rest() {
    if (!plan_.part.read_rest) return {};
    if (outputs_.on_motion && !plan_.start) commands_.preheat();
    core::Result<PartSummary> summary = plan_.part.read_rest();
    if (!summary.ok()) return summary.error();
    plan_.part.summary = std::move(summary).value();
    plan_.part.read_rest = nullptr;
    for (const std::string& warning : plan_.part.summary.warnings) signals_.warnings.put(warning);
    return {};
  }

  // The skirt primes the nozzle: it is laid around the first object alone.
  [[nodiscard]] core::Result<PrintPlan> plan_of(ObjectSequence& objects, std::size_t object) {
    core::Result<OpenedPart> part = objects.open(object);
    if (!part.ok()) return part.error();
    PrintPlan plan{plan_.settings,     std::move(part).value(), objects.path(object),
                   plan_.on_bad_layer, plan_.on_floating,       plan_.spool_folder,
                   plan_.threads,      plan_.command_form};
    if (object > 0) plan.settings.skirt_loops = 0;
    plan.turn = {static_cast<int>(object), objects.layers_before(object),
                 plan_.part.summary.layers};
    return plan;
  }

  PrintPlan& plan_;
  const PipelineOutputs& outputs_;
  PipelineSignals& signals_;
  GeometryStatistics& statistics_;
  std::atomic<bool> refused_ = false;  // an output returned false, or there was an error
  CommandStage commands_;
};

}  // namespace

core::Result<PipelineEnd> run_pipeline(PrintPlan& print_plan, const PipelineOutputs& outputs,
                                       PipelineSignals& signals, GeometryStatistics& statistics) {
  // What was read and sorted until now is told by the part, in its end.
  const PartCounters used = print_plan.part.counters ? print_plan.part.counters() : PartCounters();
  statistics.clock.set_seconds(Stage::kOpen,
                               process_cpu_seconds() - used.read_cpu_s - used.sort_cpu_s);
  core::Result<PipelineEnd> end = PrintRun(print_plan, outputs, signals, statistics).run();
  statistics.ended_cpu_s = process_cpu_seconds();
  return end;
}

}  // namespace host
