// What a list of executed commands lays: each straight piece of road, by its ends, height, filament
// and feed. Travels, retractions and primes leave no trace, as long as they lay nothing.
#pragma once

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace test {

struct LaidPiece {
  std::array<double, 2> from{}, to{};
  double height = 0;
  double filament = 0;
  double feed = 0;

  bool operator==(const LaidPiece&) const = default;
};

class RoadTracer {
 public:
  // REQUIRES: moves spelled out; absolute positions, relative filament.
  void execute(const std::string& text) {
    const std::string word = text.substr(0, text.find(' '));
    if (word == "G92") {
      read(text, 'Z', height_);
    } else if (word == "G28") {
      place_ = {-1, -1};  // nothing is laid from there
    } else if (word == "G0" || word == "G1") {
      move(text);
    }
  }

  [[nodiscard]] const std::vector<LaidPiece>& laid() const { return laid_; }
  // Filament pushed or drawn back while x and y stood still.
  [[nodiscard]] double primed_mm() const { return primed_mm_; }

 private:
  static bool read(const std::string& text, char letter, double& value) {
    const std::size_t at = text.find(std::string(" ") + letter);
    if (at == std::string::npos) return false;
    value = std::strtod(text.c_str() + at + 2, nullptr);
    return true;
  }

  void move(const std::string& text) {
    const std::array<double, 2> from = place_;
    const bool x = read(text, 'X', place_[0]);
    const bool y = read(text, 'Y', place_[1]);
    read(text, 'Z', height_);
    read(text, 'F', feed_);
    double filament = 0;
    if (!read(text, 'E', filament)) return;
    if (x || y) {
      laid_.push_back({from, place_, height_, filament, feed_});
    } else {
      primed_mm_ += filament;
    }
  }

  std::array<double, 2> place_{-1, -1};
  double height_ = 0;
  double feed_ = 0;
  double primed_mm_ = 0;
  std::vector<LaidPiece> laid_;
};

inline std::vector<LaidPiece> laid_by(const std::vector<std::string>& lines) {
  RoadTracer tracer;
  for (const std::string& line : lines) tracer.execute(line);
  return tracer.laid();
}

}  // namespace test
