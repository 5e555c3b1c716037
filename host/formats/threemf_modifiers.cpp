#include "host/formats/threemf_modifiers.h"

#include <string>
#include <utility>

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Status;

// An object's own settings hold for all its plastic.
bool is_meant(const ThreeMfModifier& modifier, const ThreeMfItem& item) {
  return modifier.role != MeshRole::kSolid || item.key == MeshStore::Key{0, modifier.object};
}

Status gather(const ThreeMfModifier& modifier, const std::vector<ThreeMfItem>& items,
              MeshStore& store, FacetSpool& facets) {
  store.clear_items();
  for (const ThreeMfItem& item : items) {
    if (!is_meant(modifier, item)) continue;
    std::string cause = store.add_item(item.key, item.transform, false, modifier.role);
    if (!cause.empty()) return Error{ErrorCode::kBadPart, std::move(cause)};
  }
  while (true) {
    MeshStore::Next next = store.next();
    if (!next.error.empty()) return Error{ErrorCode::kBadPart, std::move(next.error)};
    if (!next.triangle) return {};
    if (Status added = facets.add(*next.triangle); !added.ok()) return added;
  }
}

}  // namespace

core::Result<std::vector<ModifierBody>> gather_modifiers(
    const std::vector<ThreeMfModifier>& modifiers, const std::vector<ThreeMfItem>& items,
    MeshStore& store) {
  std::vector<ModifierBody> bodies;
  // Objects first: a modifier within them holds.
  for (const bool objects : {true, false}) {
    for (const ThreeMfModifier& modifier : modifiers) {
      if ((modifier.role == MeshRole::kSolid) != objects) continue;
      ModifierBody body{modifier.name, modifier.settings};
      if (Status taken = gather(modifier, items, store, body.facets); !taken.ok()) {
        return taken.error();
      }
      if (!body.facets.empty()) bodies.push_back(std::move(body));
    }
  }
  store.clear_items();
  return bodies;
}

}  // namespace host
