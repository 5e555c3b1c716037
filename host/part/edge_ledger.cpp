#include "host/part/edge_ledger.h"

#include <algorithm>
#include <cstdlib>

namespace host {
namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t number) {
  number = (number ^ number >> 30) * 0xBF58476D1CE4E5B9;
  number = (number ^ number >> 27) * 0x94D049BB133111EB;
  return number ^ number >> 31;
}

std::uint64_t number_of(const core::Vertex& vertex) {
  const std::uint64_t plane = std::uint64_t{static_cast<std::uint32_t>(vertex.x)} << 32 |
                              static_cast<std::uint32_t>(vertex.y);
  return mixed(plane + 0x9E3779B97F4A7C15 * mixed(static_cast<std::uint64_t>(vertex.z) + 1));
}

// Positions are trusted if this many edges have a cell of their own for each edge that shares one.
constexpr std::int64_t kClearPerShared = 4;

// Half of a sum modulo 2^64 that is `count` times (±2) the sum of two coordinates.
std::int64_t middle(std::uint64_t sum, std::int64_t count) {
  return static_cast<std::int64_t>(sum) / (2 * count);
}

}  // namespace

void EdgeLedger::add(const core::Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  const std::uint64_t p = number_of(a), q = number_of(b), r = number_of(c);
  add_edge(a, p, b, q);
  add_edge(b, q, c, r);
  add_edge(c, r, a, p);
}

void EdgeLedger::add_edge(const core::Vertex& p, std::uint64_t p_number, const core::Vertex& q,
                          std::uint64_t q_number) {
  const std::uint64_t both = mixed(p_number + q_number) + mixed(p_number ^ q_number);
  // 1, or -1 modulo 2^64.
  const std::uint64_t sign = p_number < q_number ? 1 : ~std::uint64_t{0};
  sum_ += sign * both;
  parity_ ^= both;
  Cell& cell = cells_[both % kCells];
  cell.count += p_number < q_number ? 1 : -1;
  cell.number += sign * both;
  cell.x += sign * static_cast<std::uint64_t>(std::int64_t{p.x} + q.x);
  cell.y += sign * static_cast<std::uint64_t>(std::int64_t{p.y} + q.y);
  cell.z += sign * static_cast<std::uint64_t>(p.z + q.z);
}

std::optional<EdgeLedger::Turned> EdgeLedger::turned() const {
  if (closed()) return std::nullopt;
  // If every edge occurs an even number of times, the remaining edges run the same way twice.
  const bool only_turned = parity_ == 0;
  Turned turned;
  std::int64_t clear = 0, shared = 0;
  for (std::size_t i = 0; i < kCells; ++i) {
    const Cell& cell = cells_[i];
    if (cell.count == 0 && cell.number == 0) continue;
    // A single edge's number leads back to its cell.
    const std::uint64_t twice = cell.count < 0 ? 0 - cell.number : cell.number;
    if (std::abs(cell.count) != 2 || twice % 2 != 0 || twice / 2 % kCells != i) {
      shared += std::max<std::int64_t>(2, std::abs(cell.count) / 2);
      continue;
    }
    const std::int64_t count = cell.count < 0 ? -2 : 2;
    const core::Vertex at{static_cast<std::int32_t>(middle(cell.x, count)),
                          static_cast<std::int32_t>(middle(cell.y, count)), middle(cell.z, count)};
    if (clear == 0 || at.z < turned.lowest.z) turned.lowest = at;
    turned.box.add(core::Point{at.x, at.y});
    ++clear;
  }
  turned.edges = clear + (only_turned ? shared : 0);
  turned.exact = !only_turned || shared == 0;
  // Edges that share a cell lie elsewhere, but near the many others.
  turned.placed = clear > 0 && (!only_turned || kClearPerShared * shared <= clear);
  if (!turned.placed) turned.box = {};
  if (turned.edges == 0) return std::nullopt;
  return turned;
}

}  // namespace host
