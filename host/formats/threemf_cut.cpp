#include "host/formats/threemf_cut.h"

#include <cstdint>
#include <string>

#include "host/formats/mesh_extent.h"  // MeshExtent

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Status;

// Items that are cut together.
struct Group {
  std::vector<Shell> solid;
  std::vector<Shell> negative;
  std::vector<MeshExtent> solid_extents;
  std::vector<MeshExtent> negative_extents;
};

bool meet(const MeshExtent& a, const MeshExtent& b) {
  return !a.box.empty() && !b.box.empty() && a.box.overlaps(b.box) && a.lowest_z <= b.highest_z &&
         b.lowest_z <= a.highest_z;
}

bool any_meets(const std::vector<MeshExtent>& extents, const MeshExtent& one) {
  for (const MeshExtent& extent : extents) {
    if (meet(extent, one)) return true;
  }
  return false;
}

class ItemCutter {
 public:
  explicit ItemCutter(ShellTree& tree) : tree_(tree) {}

  [[nodiscard]] Status cut(const std::vector<ThreeMfItem>& items) {
    std::size_t cut_items = 0;
    for (const ThreeMfItem& item : items) cut_items += is_cut(item) ? 1 : 0;
    for (const ThreeMfItem& item : items) {
      if (!is_cut(item)) {
        whole_.push_back(shell(item, MeshRole::kSolid));
      } else if (Status added = add(item, cut_items > 1); !added.ok()) {
        return added;
      }
    }
    if (2 * groups_.size() + 1 > kOperandsMax) {
      return refused(std::to_string(groups_.size()) +
                     " objects with negative parts that reach into one another, more than " +
                     std::to_string((kOperandsMax - 1) / 2) + "; print them apart");
    }
    build();
    return {};
  }

 private:
  [[nodiscard]] Error refused(const std::string& cause) const {
    return {ErrorCode::kBadPart, tree_.name + ": " + cause};
  }

  [[nodiscard]] bool is_cut(const ThreeMfItem& item) const {
    return tree_.store.count(item.key, MeshRole::kNegative) > 0;
  }

  [[nodiscard]] static Shell shell(const ThreeMfItem& item, MeshRole role) {
    return {item.key, false, item.transform, role};
  }

  [[nodiscard]] Status add(const ThreeMfItem& item, bool among_others) {
    MeshExtent solid, negative;
    if (among_others) {
      if (Status seen = extent_of(item, MeshRole::kSolid, solid); !seen.ok()) return seen;
      if (Status seen = extent_of(item, MeshRole::kNegative, negative); !seen.ok()) return seen;
    }
    Group* group = nullptr;
    for (Group& one : groups_) {
      const bool apart =
          !any_meets(one.solid_extents, negative) && !any_meets(one.negative_extents, solid);
      if (apart && group == nullptr) group = &one;
    }
    if (group == nullptr) group = &groups_.emplace_back();
    group->solid.push_back(shell(item, MeshRole::kSolid));
    group->negative.push_back(shell(item, MeshRole::kNegative));
    group->solid_extents.push_back(solid);
    group->negative_extents.push_back(negative);
    return {};
  }

  [[nodiscard]] Status extent_of(const ThreeMfItem& item, MeshRole role, MeshExtent& into) {
    tree_.store.clear_items();
    std::string cause = tree_.store.add_item(item.key, item.transform, false, role);
    while (cause.empty()) {
      const MeshStore::Next next = tree_.store.next();
      cause = next.error;
      if (!next.triangle) break;
      into.add(*next.triangle);
    }
    tree_.store.clear_items();
    return cause.empty() ? Status() : refused(cause);
  }

  std::size_t add_operand(std::vector<Shell> shells) {
    tree_.nodes.push_back({ShellNode::Kind::kOperand, tree_.operands.size(), {}});
    tree_.operands.push_back(std::move(shells));
    return tree_.nodes.size() - 1;
  }

  void build() {
    std::vector<std::size_t> parts;
    if (!whole_.empty()) parts.push_back(add_operand(std::move(whole_)));
    for (Group& group : groups_) {
      const std::size_t solid = add_operand(std::move(group.solid));
      const std::size_t negative = add_operand(std::move(group.negative));
      tree_.nodes.push_back({ShellNode::Kind::kDifference, 0, {solid, negative}});
      parts.push_back(tree_.nodes.size() - 1);
    }
    if (parts.size() > 1) tree_.nodes.push_back({ShellNode::Kind::kUnion, 0, std::move(parts)});
  }

  ShellTree& tree_;
  std::vector<Shell> whole_;
  std::vector<Group> groups_;
};

}  // namespace

Status cut_items(const std::vector<ThreeMfItem>& items, ShellTree& tree) {
  return ItemCutter(tree).cut(items);
}

}  // namespace host
