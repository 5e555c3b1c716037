// What the virtual controller says at length, as Marlin bugfix-2.1.x (2024-10) with its default
// configuration says it.
#pragma once

#include <string_view>

namespace firmware_link {

inline constexpr std::string_view kBanner =
    "start\n"
    "Marlin bugfix-2.1.x\n"
    "echo: Last Updated: 2024-10-12 | Author: (none, default config)\n"
    "echo: Compiled: Oct 12 2024\n"
    "echo: Free Memory: 5455  PlannerBufferBytes: 1264\n"
    "echo:Hardcoded Default Settings Loaded\n"
    "echo:; Linear Units:\n"
    "echo:  G21 ; (mm)\n"
    "echo:; Temperature Units:\n"
    "echo:  M149 C ; Units in Celsius\n"
    "echo:; Filament settings (Disabled):\n"
    "echo:  M200 S0 D1.75\n"
    "echo:; Steps per unit:\n"
    "echo:  M92 X80.00 Y80.00 Z400.00 E500.00\n"
    "echo:; Max feedrates (units/s):\n"
    "echo:  M203 X300.00 Y300.00 Z5.00 E25.00\n"
    "echo:; Max Acceleration (units/s2):\n"
    "echo:  M201 X3000.00 Y3000.00 Z100.00 E10000.00\n"
    "echo:; Acceleration (units/s2) (P<print-accel> R<retract-accel> T<travel-accel>):\n"
    "echo:  M204 P3000.00 R3000.00 T3000.00\n"
    "echo:; Advanced (B<min_segment_time_us> S<min_feedrate> T<min_travel_feedrate> J<junc_dev>):\n"
    "echo:  M205 B20000.00 S0.00 T0.00 J0.01\n"
    "echo:; Home offset:\n"
    "echo:  M206 X0.00 Y0.00 Z0.00\n"
    "echo:; Hotend PID:\n"
    "echo:  M301 P22.20 I1.08 D114.00\n";

inline constexpr std::string_view kFirmwareName =
    "FIRMWARE_NAME:Marlin bugfix-2.1.x (Oct 12 2024 00:00:00) "
    "SOURCE_CODE_URL:github.com/MarlinFirmware/Marlin PROTOCOL_VERSION:1.0 "
    "MACHINE_TYPE:3D Printer KINEMATICS:Cartesian EXTRUDER_COUNT:1 "
    "UUID:cede2a2f-41a2-4748-9b12-c55c62f367ff\n";

// The line of EMERGENCY_PARSER follows between the two.
inline constexpr std::string_view kCapabilitiesBefore =
    "Cap:SERIAL_XON_XOFF:0\nCap:BINARY_FILE_TRANSFER:0\nCap:EEPROM:0\nCap:VOLUMETRIC:1\n"
    "Cap:AUTOREPORT_POS:0\nCap:AUTOREPORT_TEMP:1\nCap:PROGRESS:0\nCap:PRINT_JOB:1\n"
    "Cap:AUTOLEVEL:0\nCap:RUNOUT:0\nCap:Z_PROBE:0\nCap:LEVELING_DATA:0\nCap:BUILD_PERCENT:0\n"
    "Cap:SOFTWARE_POWER:0\nCap:TOGGLE_LIGHTS:0\nCap:CASE_LIGHT_BRIGHTNESS:0\n";
inline constexpr std::string_view kCapabilitiesBehind =
    "Cap:HOST_ACTION_COMMANDS:0\nCap:PROMPT_SUPPORT:0\nCap:SDCARD:0\nCap:MULTI_VOLUME:0\n"
    "Cap:REPEAT:0\nCap:SD_WRITE:0\nCap:AUTOREPORT_SD_STATUS:0\nCap:LONG_FILENAME:0\n"
    "Cap:LFN_WRITE:0\nCap:CUSTOM_FIRMWARE_UPLOAD:0\nCap:EXTENDED_M20:0\n"
    "Cap:THERMAL_PROTECTION:1\nCap:MOTION_MODES:0\nCap:ARCS:1\nCap:BABYSTEPPING:0\n"
    "Cap:CHAMBER_TEMPERATURE:0\nCap:COOLER_TEMPERATURE:0\n";

inline constexpr std::string_view kPrusaBanner =
    "start\n"
    "echo: 3.13.2-7080\n"
    "echo: Last Updated: Nov  6 2023 10:42:38 | Author: (none, default config)\n"
    "echo: Free Memory: 2347  PlannerBufferBytes: 1760\n"
    "echo:Hardcoded Default Settings Loaded\n";

inline constexpr std::string_view kPrusaIdentity =
    "FIRMWARE_NAME:Prusa-Firmware 3.13.2 based on Marlin "
    "FIRMWARE_URL:https://github.com/prusa3d/Prusa-Firmware PROTOCOL_VERSION:1.0 "
    "MACHINE_TYPE:Prusa i3 MK3S EXTRUDER_COUNT:1 UUID:00000000-0000-0000-0000-000000000000\n"
    "Cap:AUTOREPORT_TEMP:1\nCap:AUTOREPORT_FANS:1\nCap:AUTOREPORT_POSITION:1\n"
    "Cap:EXTENDED_M20:1\nCap:PRUSA_MMU2:1\n";

inline constexpr std::string_view kRepRapIdentity =
    "FIRMWARE_NAME: RepRapFirmware for Duet 2 WiFi/Ethernet FIRMWARE_VERSION: 3.4.5 "
    "ELECTRONICS: Duet WiFi 1.02 or later FIRMWARE_DATE: 2022-11-30 19:36:12\n";

}  // namespace firmware_link
