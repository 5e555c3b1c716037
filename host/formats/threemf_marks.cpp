#include "host/formats/threemf_marks.h"

#include <cstdint>
#include <string>
#include <utility>

#include "host/formats/facet_paint.h"   // is_paint, each_painted_piece
#include "host/formats/text_scanner.h"  // shown

namespace host {
namespace {

using core::Status;

class MarkGatherer {
 public:
  MarkGatherer(const std::vector<ThreeMfItem>& items, MeshStore& store)
      : items_(items), store_(store) {}

  [[nodiscard]] core::Result<std::unique_ptr<MarkedFacets>> gather() {
    if (Status taken = painted(); !taken.ok()) return taken.error();
    if (Status taken = bodies(MeshRole::kEnforcer, SupportMark::kEnforcer); !taken.ok()) {
      return taken.error();
    }
    if (Status taken = bodies(MeshRole::kBlocker, SupportMark::kBlocker); !taken.ok()) {
      return taken.error();
    }
    if (!facets_->bodies_extent().box.empty()) {
      if (Status taken = printed(); !taken.ok()) return taken.error();
    }
    store_.clear_items();
    if (damaged_ > 0) {
      facets_->warnings.push_back(counted(damaged_) +
                                  " painted for supports in a way that is damaged, the first is " +
                                  first_damaged_ + "; taken as not painted; export the part again");
    }
    if (unknown_ > 0) {
      facets_->warnings.push_back(counted(unknown_) +
                                  " painted for supports as neither enforced nor blocked; where "
                                  "they are, nothing is marked");
    }
    return std::move(facets_);
  }

 private:
  static std::string counted(std::int64_t count) {
    return std::to_string(count) + (count == 1 ? " facet is" : " facets are");
  }

  [[nodiscard]] Status add_items(MeshRole role) {
    store_.clear_items();
    for (const ThreeMfItem& item : items_) {
      std::string cause = store_.add_item(item.key, item.transform, false, role);
      if (!cause.empty()) return core::Error{core::ErrorCode::kBadPart, std::move(cause)};
    }
    return {};
  }

  // Of all items' triangles with that role.
  template <typename Take>  // Status(const core::Triangle&)
  [[nodiscard]] Status each(MeshRole role, const Take& take) {
    if (Status added = add_items(role); !added.ok()) return added;
    while (true) {
      MeshStore::Next next = store_.next();
      if (!next.error.empty()) {
        return core::Error{core::ErrorCode::kBadPart, std::move(next.error)};
      }
      if (!next.triangle) return {};
      if (Status taken = take(*next.triangle); !taken.ok()) return taken;
    }
  }

  [[nodiscard]] Status bodies(MeshRole role, SupportMark mark) {
    return each(role, [this, mark](const core::Triangle& triangle) {
      return facets_->bodies(mark).add(triangle);
    });
  }

  [[nodiscard]] Status printed() {
    return each(MeshRole::kSolid, [this](const core::Triangle& triangle) -> Status {
      facets_->printed.add(triangle);
      return {};
    });
  }

  [[nodiscard]] Status painted() {
    if (Status added = add_items(MeshRole::kSolid); !added.ok()) return added;
    return store_.each_painted([this](const MeshStore::Painted& facet) -> Status {
      if (!is_paint(facet.text)) {
        if (damaged_++ == 0) {
          first_damaged_ = store_.name_of(facet.number) + ", '" + shown(facet.text) + "'";
        }
        return {};
      }
      bool unknown = false;
      Status taken = each_painted_piece(
          facet.text, facet.triangle, [&](const core::Triangle& piece, FacetPaint paint) -> Status {
            unknown = unknown || paint == FacetPaint::kUnknown;
            if (paint == FacetPaint::kUnknown) return {};
            const SupportMark mark =
                paint == FacetPaint::kEnforcer ? SupportMark::kEnforcer : SupportMark::kBlocker;
            return facets_->painted(mark).add(piece);
          });
      unknown_ += unknown ? 1 : 0;
      return taken;
    });
  }

  const std::vector<ThreeMfItem>& items_;
  MeshStore& store_;
  std::unique_ptr<MarkedFacets> facets_ = std::make_unique<MarkedFacets>();
  std::int64_t damaged_ = 0;
  std::int64_t unknown_ = 0;
  std::string first_damaged_;
};

}  // namespace

core::Result<std::unique_ptr<MarkedFacets>> gather_marks(const std::vector<ThreeMfItem>& items,
                                                         MeshStore& store) {
  return MarkGatherer(items, store).gather();
}

}  // namespace host
