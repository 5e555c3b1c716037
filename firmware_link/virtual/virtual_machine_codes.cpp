// The virtual controller's M commands.
#include <algorithm>
#include <chrono>
#include <iterator>

#include "firmware_link/virtual/virtual_firmware.h"
#include "firmware_link/virtual/virtual_speech.h"  // identity_of
#include "firmware_link/virtual/virtual_texts.h"   // kBanner

namespace firmware_link {
namespace {

// Obeyed without a word, and without an effect that could be seen here.
constexpr std::int64_t kSilentCodes[] = {17,  31,  73,  75,  76,  77,  78,  85,  92,
                                         108, 111, 117, 119, 120, 121, 200, 206, 218,
                                         301, 302, 410, 420, 428, 500, 501, 502, 504};

// Klipper has one acceleration: S, or the smaller of P and T where both are told.
void set_klipper_acceleration(std::string_view text, VirtualLimits& limits) {
  auto told = word(text, 'S', 3);
  const auto print = word(text, 'P', 3), travel = word(text, 'T', 3);
  if (!told && print && travel) told = std::min(*print, *travel);
  if (!told || *told <= 0) return;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = static_cast<double>(*told) * 1e-3;
}

}  // namespace

bool VirtualController::Firmware::handle_m(std::int64_t code, std::string_view text) {
  if (handle_m_temperature(code, text) || handle_m_host(code, text)) return true;
  if (handle_m_set(code, text)) return true;
  switch (code) {
    case 18:
    case 84:
      position_.set_homed(false);
      [[fallthrough]];
    case 400:
      pause_was_asked_ = true;
      handler_.dwell = Duration(0);
      wait(Waiting::kPlannerEmpty);
      return true;
    case 82:
      position_.set_relative_filament(false);
      return true;
    case 83:
      position_.set_relative_filament(true);
      return true;
    case 106:
      heaters_.fan =
          static_cast<int>(std::clamp<std::int64_t>(word(text, 'S', 0).value_or(255), 0, 255));
      return true;
    case 107:
      heaters_.fan = 0;
      return true;
    case 211:
      if (speaks(VirtualDialect::kMarlin) && !options_.tells_travel) return false;
      if (!word(text, 'S', 0)) print_travel();
      return true;
    default:
      return std::find(std::begin(kSilentCodes), std::end(kSilentCodes), code) !=
             std::end(kSilentCodes);
  }
}

// What holds until it is set again.
bool VirtualController::Firmware::handle_m_set(std::int64_t code, std::string_view text) {
  const bool reprap = speaks(VirtualDialect::kRepRap);
  const bool klipper = speaks(VirtualDialect::kKlipper);
  const auto percent = [&](std::int64_t before) {
    return std::clamp<std::int64_t>(word(text, 'S', 0).value_or(before), 10, 999);
  };
  switch (code) {
    case 201:
      if (!klipper) set_.limits.set_accelerations_max(text);
      return true;
    case 203:
      if (!klipper) set_.limits.set_speeds(text, reprap);
      return true;
    case 204:
      // RepRapFirmware reads P and T alone.
      if (reprap && !(word(text, 'P', 0) && word(text, 'T', 0))) return false;
      if (klipper) {
        set_klipper_acceleration(text, set_.limits);
      } else {
        set_.limits.set_accelerations(text);
      }
      return true;
    case 205:
      if (!klipper && !reprap) set_.limits.set_corners(text, false);
      return true;
    case 566:
      if (reprap) set_.limits.set_corners(text, true);
      return reprap;
    case 220:
      position_.set_feed_percent(percent(position_.feed_percent()));
      return true;
    case 221:
      set_.flow_percent = percent(set_.flow_percent);
      return true;
    case 572:
    case 900: {
      const bool has = code == 572 ? reprap : !reprap && !klipper;
      const auto told = word(text, code == 572 ? 'S' : 'K', 5);
      if (has && told) set_.pressure_advance = static_cast<double>(*told) * 1e-5;
      return has;
    }
    default:
      return false;
  }
}

void VirtualController::Firmware::print_travel() {
  if (!speaks(VirtualDialect::kMarlin)) return;
  print("echo:; Soft endstops:\n  M211 S1 ; ON\n");
  const double left = options_.bed_origin_x_mm, front = options_.bed_origin_y_mm;
  print_format("  Min:  X%.2f Y%.2f Z0.00   Max:  X%.2f Y%.2f Z%.2f\n", left, front,
               left + options_.bed_x_mm, front + options_.bed_y_mm, options_.height_z_mm);
}

bool VirtualController::Firmware::handle_m_temperature(std::int64_t code, std::string_view text) {
  const auto target = word(text, 'S', 2);
  const auto celsius = [&] { return static_cast<double>(*target) * 1e-2; };
  switch (code) {
    case 104:
    case 109:
      if (target) heaters_.nozzle.set_target(celsius());
      if (target && celsius() == 0) standing_.cooled();
      break;
    case 140:
    case 190:
      if (target) heaters_.bed.set_target(celsius());
      break;
    case 105:
      handler_.asks_temperatures = true;
      return true;
    case 155:
      if (!numbers_lines(options_.dialect)) return false;
      reports_.temperatures.reset();
      if (const auto interval = word(text, 'S', 0); interval && *interval > 0) {
        reports_.temperatures = std::chrono::seconds(std::min<std::int64_t>(*interval, 60));
        reports_.temperatures_next = now_ + *reports_.temperatures;
      }
      return true;
    default:
      return false;
  }
  if (code == 109 || code == 190) {
    pause_was_asked_ = true;
    handler_.warm_since.reset();
    handler_.heat_report_next = now_;
    wait(code == 109 ? Waiting::kNozzle : Waiting::kBed);
  }
  return true;
}

// Commands that only talk.
bool VirtualController::Firmware::handle_m_host(std::int64_t code, std::string_view text) {
  switch (code) {
    case 110:
      if (const auto number = word(text, 'N', 0)) {
        numbers_.set_last(*number);
      } else {
        print_format("Line: %lld\n", static_cast<long long>(numbers_.last()));
      }
      return true;
    case 112:
      kill("echo:M112 Shutdown\n");
      return true;
    case 113:
      if (!numbers_lines(options_.dialect)) return false;
      if (const auto interval = word(text, 'S', 0)) {
        reports_.busy_interval_s = static_cast<int>(std::clamp<std::int64_t>(*interval, 0, 60));
      } else {
        print_format("echo:M113 S%d\n", reports_.busy_interval_s);
      }
      return true;
    case 114:
      print_position();
      return true;
    case 115:
      print(identity_of(options_));
      handler_.asks_identity = speaks(VirtualDialect::kKlipper);
      return true;
    case 118: {
      std::string_view message = text.substr(std::min<std::size_t>(text.size(), 5));
      if (message.substr(0, 3) == "E1 ") {
        print("echo:");
        message.remove_prefix(3);
      } else if (message.substr(0, 3) == "A1 ") {
        print("//");
        message.remove_prefix(3);
      }
      print(message);
      print("\r\n");
      return true;
    }
    case 503:
      print(kBanner.substr(kBanner.find("echo:; Linear Units")));
      return true;
    case 999:
      flush_and_request_resend();
      return true;
    default:
      return false;
  }
}

}  // namespace firmware_link
