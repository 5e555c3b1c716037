#include "host/formats/support_marks.h"

#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

namespace host {
namespace {

static_assert(std::is_trivially_copyable_v<core::Triangle>);

constexpr SpillUse kForMarks{"marks of supports", "set TMPDIR"};

void add(std::int64_t count, const std::string& one, const std::string& rest, std::string& into) {
  if (count == 0) return;
  into += (into.empty() ? "" : ", ") + std::to_string(count) + " " + one + (count == 1 ? "" : "s") +
          rest;
}

}  // namespace

core::Status FacetSpool::add(const core::Triangle& facet) {
  if (!spool_) {
    core::Result<RecordSpool> spool = RecordSpool::create("", kForMarks);
    if (!spool.ok()) return spool.error();
    spool_ = std::move(spool).value();
    spool_->go_to_start();
  }
  extent_.add(facet);
  std::array<char, sizeof(core::Triangle)> bytes{};
  std::memcpy(bytes.data(), &facet, sizeof(facet));
  return spool_->append({bytes.data(), bytes.size()});
}

core::Result<std::optional<core::Triangle>> FacetSpool::next() {
  if (!spool_) return std::optional<core::Triangle>();
  core::Result<std::optional<RecordSpool::Record>> record = spool_->next();
  if (!record.ok()) return record.error();
  if (!record.value()) return std::optional<core::Triangle>();
  core::Triangle facet;
  std::memcpy(&facet, record.value()->bytes.data(), sizeof(facet));
  return std::optional<core::Triangle>(facet);
}

MeshExtent MarkedFacets::bodies_extent() const {
  MeshExtent all;
  for (const FacetSpool& bodies : bodies_) {
    if (!bodies.empty()) all.add(bodies.extent());
  }
  return all;
}

std::string MarkCounts::text() const {
  std::string all;
  add(enforcers, "support enforcer", "", all);
  add(blockers, "support blocker", "", all);
  add(painted, "facet", " painted for supports", all);
  return all;
}

}  // namespace host
