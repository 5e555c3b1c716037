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
constexpr std::int64_t kSilentCodes[] = {17,  31,  75,  76,  77,  78,  85,  92,  108, 111,
                                         117, 119, 120, 121, 200, 201, 203, 204, 205, 206,
                                         218, 301, 302, 410, 428, 500, 501, 502, 504};

}  // namespace

bool VirtualController::Firmware::handle_m(std::int64_t code, std::string_view text) {
  if (handle_m_temperature(code, text) || handle_m_host(code, text)) return true;
  switch (code) {
    case 18:
    case 84:
      homed_ = {};
      [[fallthrough]];
    case 400:
      pause_was_asked_ = true;
      dwell_ = Duration(0);
      wait(Waiting::kPlannerEmpty);
      return true;
    case 82:
      relative_e_ = false;
      return true;
    case 83:
      relative_e_ = true;
      return true;
    case 106:
      fan_ = static_cast<int>(std::clamp<std::int64_t>(word(text, 'S', 0).value_or(255), 0, 255));
      return true;
    case 107:
      fan_ = 0;
      return true;
    case 211:
      if (speaks(VirtualDialect::kMarlin) && !options_.tells_travel) return false;
      if (!word(text, 'S', 0)) print_travel();
      return true;
    case 220:
      feed_percent_ = std::clamp<std::int64_t>(word(text, 'S', 0).value_or(100), 10, 999);
      return true;
    case 221:
      return true;
    default:
      return std::find(std::begin(kSilentCodes), std::end(kSilentCodes), code) !=
             std::end(kSilentCodes);
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
      if (target) nozzle_.set_target(celsius());
      if (target && celsius() == 0) laid_ = false;
      break;
    case 140:
    case 190:
      if (target) bed_.set_target(celsius());
      break;
    case 105:
      temperatures_asked_ = true;
      return true;
    case 155:
      if (!numbers_lines(options_.dialect)) return false;
      auto_report_.reset();
      if (const auto interval = word(text, 'S', 0); interval && *interval > 0) {
        auto_report_ = std::chrono::seconds(std::min<std::int64_t>(*interval, 60));
        auto_report_next_ = now_ + *auto_report_;
      }
      return true;
    default:
      return false;
  }
  if (code == 109 || code == 190) {
    pause_was_asked_ = true;
    within_window_since_.reset();
    heat_report_next_ = now_;
    wait(code == 109 ? Waiting::kNozzle : Waiting::kBed);
  }
  return true;
}

// Commands that only talk.
bool VirtualController::Firmware::handle_m_host(std::int64_t code, std::string_view text) {
  switch (code) {
    case 110:
      if (const auto number = word(text, 'N', 0)) {
        last_number_ = *number;
      } else {
        print_format("Line: %lld\n", static_cast<long long>(last_number_));
      }
      return true;
    case 112:
      kill("echo:M112 Shutdown\n");
      return true;
    case 113:
      if (!numbers_lines(options_.dialect)) return false;
      if (const auto interval = word(text, 'S', 0)) {
        busy_interval_s_ = static_cast<int>(std::clamp<std::int64_t>(*interval, 0, 60));
      } else {
        print_format("echo:M113 S%d\n", busy_interval_s_);
      }
      return true;
    case 114:
      print_position();
      return true;
    case 115:
      print(identity_of(options_));
      identity_asked_ = speaks(VirtualDialect::kKlipper);
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
