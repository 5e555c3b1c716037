#include "core/roads/beading.h"

#include <algorithm>
#include <cmath>

#include "core/offsets/slice_offsets.h"  // perimeter_spacing

namespace core {

Beading::Beading(const Settings& settings, Length height)
    : pairs_(settings.perimeters),
      spacing_(static_cast<double>(perimeter_spacing(settings, height).units())),
      rim_(static_cast<double>(settings.road_width.units()) - spacing_),
      room_min_(static_cast<double>(settings.road_width_min.units() - kRoomSlack.units()) - rim_) {}

int Beading::count_at(double room) const {
  if (room >= room_wide()) return wide();
  if (room < room_min_) return 0;
  const int count = static_cast<int>(std::floor(room / spacing_ + 0.5));
  return std::clamp(count, 1, 2 * pairs_ + 1);
}

double Beading::room_from(int count) const {
  if (count <= 1) return room_min_;
  return count == wide() ? room_wide() : (count - 0.5) * spacing_;
}

int Beading::levels(int count) const { return count == wide() ? pairs_ + 1 : count / 2; }

Bead Beading::bead(int level, const BeadState& state) const {
  const Bead here = bead_of(level, state.count, state.radius);
  if (state.share == 0 || level > levels(state.toward)) return here;
  const Bead there = bead_of(level, state.toward, state.radius);
  return {here.depth + state.share * (there.depth - here.depth),
          here.room + state.share * (there.room - here.room)};
}

Bead Beading::bead_of(int level, int count, double radius) const {
  const double outside = rim_ / 2 + (level - 1) * spacing_;
  if (count == wide()) {
    return level > pairs_ ? Bead{outside, 0} : Bead{outside + spacing_ / 2, spacing_};
  }
  if (count % 2 == 1 || level < count / 2) return {outside + spacing_ / 2, spacing_};
  const double room = std::max(room_from(count), this->room(radius));
  const double half = room / 2 - (level - 1) * spacing_;
  return {outside + half / 2, half};
}

double Beading::centre_room(int count, double radius) const {
  const int pairs = count / 2;
  return std::max(room(radius) - 2 * pairs * spacing_, room_min_);
}

}  // namespace core
