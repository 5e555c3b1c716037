// The roads that a list of executed commands lays: each piece, straight or an arc, with its ends,
// centre, height, filament and feed. Travels, retractions and primes are left out unless they lay
// material.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace test {

struct LaidPiece {
  std::array<double, 2> from{}, to{};
  int turn = 0;  // of an arc: 1 counter-clockwise, -1 clockwise
  std::array<double, 2> centre{};
  double height = 0;
  double filament = 0;
  double feed = 0;

  bool operator==(const LaidPiece&) const = default;
};

class RoadTracer {
 public:
  // REQUIRES: unpacked moves; absolute positions. Filament is relative, unless M82 says otherwise.
  void execute(const std::string& text) {
    const std::string word = text.substr(0, text.find(' '));
    if (word == "G92") {
      read(text, 'Z', height_);
      read(text, 'E', count_);
    } else if (word == "M82" || word == "M83") {
      absolute_ = word == "M82";
    } else if (word == "G28") {
      place_ = {-1, -1};  // nothing is laid from there
    } else if (word == "G0" || word == "G1") {
      move(text, 0);
    } else if (word == "G2" || word == "G3") {
      move(text, word == "G3" ? 1 : -1);
    }
  }

  [[nodiscard]] const std::vector<LaidPiece>& laid() const { return laid_; }
  [[nodiscard]] double height() const { return height_; }
  // Filament extruded or retracted while x and y did not move.
  [[nodiscard]] double primed_mm() const { return primed_mm_; }

 private:
  static bool read(const std::string& text, char letter, double& value) {
    const std::size_t at = text.find(std::string(" ") + letter);
    if (at == std::string::npos) return false;
    value = std::strtod(text.c_str() + at + 2, nullptr);
    return true;
  }

  void move(const std::string& text, int turn) {
    const std::array<double, 2> from = place_;
    std::array<double, 2> centre{};
    if (turn != 0) {
      read(text, 'I', centre[0]);
      read(text, 'J', centre[1]);
      centre = {from[0] + centre[0], from[1] + centre[1]};
    }
    const bool x = read(text, 'X', place_[0]);
    const bool y = read(text, 'Y', place_[1]);
    read(text, 'Z', height_);
    read(text, 'F', feed_);
    double filament = 0;
    if (!read(text, 'E', filament)) return;
    const double told = filament;
    if (absolute_) filament = std::round((told - count_) * 1e5) / 1e5;
    count_ = absolute_ ? told : count_ + told;
    if (x || y) {
      laid_.push_back({from, place_, turn, centre, height_, filament, feed_});
    } else {
      primed_mm_ += filament;
    }
  }

  std::array<double, 2> place_{-1, -1};
  double height_ = 0;
  double feed_ = 0;
  double count_ = 0;  // of filament, as the controller has it
  bool absolute_ = false;
  double primed_mm_ = 0;
  std::vector<LaidPiece> laid_;
};

inline std::vector<LaidPiece> laid_by(const std::vector<std::string>& lines) {
  RoadTracer tracer;
  for (const std::string& line : lines) tracer.execute(line);
  return tracer.laid();
}

}  // namespace test
