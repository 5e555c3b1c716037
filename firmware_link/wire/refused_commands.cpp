#include "firmware_link/wire/refused_commands.h"

#include <algorithm>
#include <array>

#include "firmware_link/wire/gcode_words.h"

namespace firmware_link {
namespace {

constexpr bool kNever = true;
constexpr bool kUnlessAllowed = false;

constexpr std::string_view kStartsOtherPrint = "starts another print, whose commands would mix in";
constexpr std::string_view kChangesFiles = "changes files on the printer's card";
constexpr std::string_view kChangesNetwork = "changes how the printer is reached";
constexpr std::string_view kWritesChip = "writes into a chip of the board";

// Sources: the lists of commands of Marlin, Prusa's firmware, Klipper, RepRapFirmware, Repetier and
// Smoothieware.
constexpr std::array kRefused = {
    // What the link itself rests on.
    RefusedCommand{"M28", kNever, "turns what follows into a file on the printer's card"},
    RefusedCommand{"M29", kNever, "ends the writing of a file on the printer's card"},
    RefusedCommand{"M110", kNever,
                   "sets the number of the next line, which rind counts by; controllers obey it "
                   "even in a text"},
    RefusedCommand{"M112", kNever, "is the emergency stop"},
    RefusedCommand{"M410", kNever, "stops the controller in the middle of a move"},
    RefusedCommand{"M510", kNever, "locks the printer, so that it answers nothing any more"},
    RefusedCommand{"M559", kNever, "turns what follows into the printer's configuration"},
    RefusedCommand{"M560", kNever, "turns what follows into the printer's web page"},
    RefusedCommand{"M575", kNever, "changes the speed of the serial line that the print comes by"},
    RefusedCommand{"M876", kNever, "answers a question that only the printer's user can answer"},
    RefusedCommand{"M928", kNever, "turns what follows into a file on the printer's card"},
    RefusedCommand{"M936", kNever, "updates the firmware"},
    RefusedCommand{"M997", kNever, "updates the firmware, which ends the print"},
    RefusedCommand{"M998", kNever, "asks for a line once more that the controller has"},
    RefusedCommand{"M999", kNever, "restarts the controller, or its queue, and loses lines"},
    RefusedCommand{"D", kNever,
                   "is a test of the firmware's developers: it restarts the board or "
                   "writes into its memory"},
    RefusedCommand{"FIRMWARE_RESTART", kNever, "restarts Klipper and its boards"},
    RefusedCommand{"RESTART", kNever, "restarts Klipper"},
    RefusedCommand{"SAVE_CONFIG", kNever, "writes Klipper's configuration and restarts it"},

    // What outlives the print.
    RefusedCommand{"M500", kUnlessAllowed, "stores the printer's settings for good"},
    RefusedCommand{"M501", kUnlessAllowed,
                   "loads the stored settings and drops those that hold now"},
    RefusedCommand{"M502", kUnlessAllowed, "sets the printer back to its factory settings"},
    RefusedCommand{"M504", kUnlessAllowed, "stores the printer's settings on some firmware"},
    RefusedCommand{"M505", kUnlessAllowed, "clears the stored settings on some firmware"},
    RefusedCommand{"M512", kUnlessAllowed, "changes the printer's password"},
    RefusedCommand{"M540", kUnlessAllowed, kChangesNetwork},
    RefusedCommand{"M551", kUnlessAllowed, "changes the printer's password"},
    RefusedCommand{"M552", kUnlessAllowed, kChangesNetwork},
    RefusedCommand{"M553", kUnlessAllowed, kChangesNetwork},
    RefusedCommand{"M554", kUnlessAllowed, kChangesNetwork},
    RefusedCommand{"M586", kUnlessAllowed, kChangesNetwork},
    RefusedCommand{"M587", kUnlessAllowed, kChangesNetwork},
    RefusedCommand{"M588", kUnlessAllowed, kChangesNetwork},
    RefusedCommand{"M589", kUnlessAllowed, kChangesNetwork},
    RefusedCommand{"M910", kUnlessAllowed, "stores the motors' currents for good"},
    RefusedCommand{"M993", kUnlessAllowed, "copies the board's memory to the card"},
    RefusedCommand{"M994", kUnlessAllowed, "overwrites the board's memory from the card"},
    RefusedCommand{"PRUSA", kUnlessAllowed,
                   "can reset the printer, or set it back to its factory settings"},
    RefusedCommand{"BLTOUCH_STORE", kUnlessAllowed, "changes the probe's own memory"},
    RefusedCommand{"ANGLE_DEBUG_WRITE", kUnlessAllowed, kWritesChip},
    RefusedCommand{"ACCELEROMETER_DEBUG_WRITE", kUnlessAllowed, kWritesChip},

    // Files on the printer, and prints from them.
    RefusedCommand{"M23", kUnlessAllowed, "opens a file on the printer's card"},
    RefusedCommand{"M24", kUnlessAllowed, kStartsOtherPrint},
    RefusedCommand{"M26", kUnlessAllowed, "moves the place in a file on the printer's card"},
    RefusedCommand{"M30", kUnlessAllowed, "deletes a file on the printer's card"},
    RefusedCommand{"M32", kUnlessAllowed, kStartsOtherPrint},
    RefusedCommand{"M33", kUnlessAllowed, "reads or writes files on the printer's card"},
    RefusedCommand{"M37", kUnlessAllowed, "makes the printer only pretend that it prints"},
    RefusedCommand{"M470", kUnlessAllowed, kChangesFiles},
    RefusedCommand{"M471", kUnlessAllowed, kChangesFiles},
    RefusedCommand{"M472", kUnlessAllowed, kChangesFiles},
    RefusedCommand{"M524", kUnlessAllowed, "ends a print"},
    RefusedCommand{"M916", kUnlessAllowed, kStartsOtherPrint},
    RefusedCommand{"SDCARD_PRINT_FILE", kUnlessAllowed, kStartsOtherPrint},
    RefusedCommand{"SDCARD_RESET_FILE", kUnlessAllowed, "ends a print from the printer's card"},
    RefusedCommand{"SDCARD_LOOP_BEGIN", kUnlessAllowed, "belongs to files on the printer's card"},
    RefusedCommand{"SDCARD_LOOP_END", kUnlessAllowed, "belongs to files on the printer's card"},
    RefusedCommand{"SDCARD_LOOP_DESIST", kUnlessAllowed, "belongs to files on the printer's card"},

    // What harms, or hides what goes on.
    RefusedCommand{"M43", kUnlessAllowed, "switches pins, heaters too, and may never end"},
    RefusedCommand{"M81", kUnlessAllowed, "switches the printer off, its fans too"},
    RefusedCommand{"M100", kUnlessAllowed, "overwrites free memory of the controller"},
    RefusedCommand{"M108", kUnlessAllowed, "ends a wait for heat, also one that rind relies on"},
    RefusedCommand{"M111", kUnlessAllowed, "makes the controller ignore moves, or talk more"},
    RefusedCommand{"M113", kUnlessAllowed, "takes away the signs that the controller is busy"},
    RefusedCommand{"M154", kUnlessAllowed, "makes the controller tell its place unasked"},
    RefusedCommand{"M155", kUnlessAllowed, "changes how often temperatures are told to rind"},
    RefusedCommand{"M562", kUnlessAllowed, "clears a heater's fault, which keeps the printer safe"},
    RefusedCommand{"RUN_SHELL_COMMAND", kUnlessAllowed, "runs a program on the printer's computer"},
};

}  // namespace

std::optional<RefusedCommand> refused_command(std::string_view command) {
  // Every D code is one, and no name is.
  if (command.starts_with('D') && is_classic(command)) command = "D";
  const auto* found =
      std::find_if(kRefused.begin(), kRefused.end(),
                   [&](const RefusedCommand& one) { return one.command == command; });
  if (found == kRefused.end()) return std::nullopt;
  return *found;
}

std::optional<RefusedCommand> refused_in(std::string_view line,
                                         const std::vector<std::string>& allowed) {
  for (const std::string& command : commands_in(line)) {
    const std::optional<RefusedCommand> refused = refused_command(command);
    if (!refused) continue;
    const bool named = std::find(allowed.begin(), allowed.end(), command) != allowed.end();
    if (refused->never || !named) return refused;
  }
  return std::nullopt;
}

}  // namespace firmware_link
