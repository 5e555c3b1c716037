// Reads G-code like a controller that was just switched on, with all modes, and records what is
// laid and where.
#pragma once

#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace test {

class GcodeMachine {
 public:
  double filament_mm = 0;       // laid while x or y moved, since mark()
  double wrong_plane_arcs = 0;  // arcs outside the plane of the bed
  double x_min = 1e9, x_max = -1e9, y_min = 1e9, y_max = -1e9;  // of those roads, on the machine
  double z_max = -1e9;
  int fan_most = 0;
  double nozzle_celsius = 0, bed_celsius = 0;

  // The print starts here.
  void mark() {
    filament_mm = 0;
    x_min = y_min = 1e9;
    x_max = y_max = z_max = -1e9;
  }

  void run(const std::string& line) {
    read(line);
    if (letter_ == 'G') {
      run_g();
    } else if (letter_ == 'M') {
      run_m();
    }
  }

 private:
  void read(const std::string& line) {
    words_.clear();
    letter_ = line.empty() ? ' ' : line[0];
    const char* at = line.c_str() + (line.empty() ? 0 : 1);
    char* end = nullptr;
    code_ = static_cast<int>(std::strtol(at, &end, 10));
    while (*end != '\0' && *end != ';') {
      const char word = *end++;
      if (word < 'A' || word > 'Z') continue;
      char* after = nullptr;
      words_[word] = std::strtod(end, &after);
      end = after;
    }
  }

  [[nodiscard]] std::optional<double> word(char letter) const {
    const auto found = words_.find(letter);
    if (found == words_.end()) return std::nullopt;
    return found->second;
  }

  void run_g() {
    if (code_ <= 3) move();
    if (code_ == 17 || code_ == 18 || code_ == 19) plane_ = code_;
    if (code_ == 20) unit_mm_ = 25.4;
    if (code_ == 21) unit_mm_ = 1;
    if (code_ == 28) at_ = {{'X', 0}, {'Y', 0}, {'Z', 0}, {'E', at_['E']}}, zero_.clear();
    if (code_ == 90 || code_ == 91) relative_ = relative_e_ = code_ == 91;
    if (code_ != 92) return;
    for (const auto& [axis, value] : words_) zero_[axis] = at_[axis] - value * unit_mm_;
  }

  void run_m() {
    if (code_ == 82) relative_e_ = false;
    if (code_ == 83) relative_e_ = true;
    if (code_ == 106) fan_most = std::max(fan_most, static_cast<int>(word('S').value_or(255)));
    if (code_ == 104 || code_ == 109) nozzle_celsius = std::max(nozzle_celsius, *word('S'));
    if (code_ == 140 || code_ == 190) bed_celsius = std::max(bed_celsius, *word('S'));
    if (code_ == 200) volumetric_ = word('D').value_or(1) != 0;
  }

  void move() {
    const auto before = at_;
    for (const char axis : {'X', 'Y', 'Z', 'E'}) {
      const auto value = word(axis);
      if (!value) continue;
      const bool relative = axis == 'E' ? relative_e_ : relative_;
      at_[axis] = *value * unit_mm_ + (relative ? at_[axis] : zero_[axis]);
    }
    const bool lays = (word('X') || word('Y')) && at_['E'] > before.at('E');
    if (!lays) return;
    if (code_ >= 2 && plane_ != 17) ++wrong_plane_arcs;
    const double volume = volumetric_ ? 4 / (3.14159265 * 1.75 * 1.75) : 1;
    filament_mm += (at_['E'] - before.at('E')) * volume;
    for (const auto& place : {before, at_}) {
      x_min = std::min(x_min, place.at('X'));
      x_max = std::max(x_max, place.at('X'));
      y_min = std::min(y_min, place.at('Y'));
      y_max = std::max(y_max, place.at('Y'));
    }
    z_max = std::max(z_max, at_['Z']);
  }

  char letter_ = ' ';
  int code_ = 0;
  int plane_ = 17;
  std::map<char, double> words_;
  std::map<char, double> at_ = {{'X', 0}, {'Y', 0}, {'Z', 0}, {'E', 0}};
  std::map<char, double> zero_;  // machine position of coordinate 0
  double unit_mm_ = 1;
  bool relative_ = false, relative_e_ = false, volumetric_ = false;
};

}  // namespace test
