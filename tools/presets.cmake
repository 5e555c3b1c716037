# Writes the presets in FOLDER (printers/*.ini and so on) as C++ into OUT, if they have changed.
set(rows "")
foreach(kind Printer Filament Quality)
  string(TOLOWER ${kind} folder)
  if(kind STREQUAL Quality)
    set(folder qualities)
  else()
    string(APPEND folder s)
  endif()
  file(GLOB names RELATIVE ${FOLDER}/${folder} ${FOLDER}/${folder}/*.ini)
  list(TRANSFORM names REPLACE "\\.ini$" "")
  list(SORT names)
  foreach(name ${names})
    file(READ ${FOLDER}/${folder}/${name}.ini text)
    string(APPEND rows "    {PresetKind::k${kind}, \"${name}\", R\"preset(${text})preset\"},\n")
  endforeach()
endforeach()
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[
#include <array>

#include "host/presets/presets.h"

namespace host {
namespace {

constexpr PresetText kPresets[] = {
@rows@};

}  // namespace

std::span<const PresetText> preset_texts() { return kPresets; }

}  // namespace host
]])
