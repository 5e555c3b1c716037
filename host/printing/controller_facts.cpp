#include "host/printing/controller_facts.h"

#include "firmware_link/session/session.h"  // Session, SessionState
#include "host/pipeline/print_settings.h"   // PrintSettings
#include "host/printing/port_clock.h"       // link_now
#include "host/printing/print_start.h"      // PrintStart
#include "host/printing/printer_link.h"     // PrinterLink
#include "host/system/stage_clock.h"        // steady_seconds

namespace host {
namespace {

using firmware_link::SessionState;

// A board that opening the port resets says `start` by then.
constexpr double kBannerWait_s = 2.5;

}  // namespace

ControllerFacts ask_controller(firmware_link::BytePort& port, double limit_s,
                               const std::function<bool()>& stop_asked) {
  const PrintSettings settings;
  PrinterLink link(settings, {kBannerWait_s, true}, port);
  PrintStart start(settings, space_of(settings), {});
  link.start_session(false);
  const double until_s = steady_seconds() + limit_s;
  ControllerFacts facts;
  const auto goes_on = [&] { return steady_seconds() < until_s && !stop_asked(); };
  while (goes_on() && link.session().state() == SessionState::kConnecting) link.step(link_now());
  facts.answered = link.session().state() == SessionState::kStreaming;
  while (goes_on() && link.session().state() == SessionState::kStreaming &&
         !start.travel_asked(link, link_now())) {
    link.step(link_now());
  }
  const firmware_link::Session& session = link.session();
  if (!facts.answered) {
    facts.why_not = session.reason().empty() ? "nobody answers" : session.reason();
    return facts;
  }
  facts.firmware = session.firmware_name();
  facts.dialect = session.dialect_name();
  facts.machine_type = session.machine_type();
  facts.travel = session.capabilities().travel;
  return facts;
}

}  // namespace host
