#include "host/formats/threemf_stacks.h"

#include <optional>
#include <utility>

#include "host/formats/number_text.h"      // parse_real
#include "host/formats/text_scanner.h"     // shown
#include "host/formats/threemf_package.h"  // without_slash
#include "host/formats/threemf_slices.h"   // kSlicedItemsMax

namespace host {

using core::Status;

Status ThreeMfStacks::take(const XmlEvent& event, int part, double unit_mm, const XmlScanner& xml) {
  if (event.name == "slicestack") {
    const std::string* id = event.attribute("id");
    const std::string* bottom = event.attribute("zbottom");
    const std::optional<double> z = bottom ? parse_real(*bottom) : 0.0;
    if (id == nullptr || !z) return xml.bad("a slicestack without id, or with no zbottom");
    if (stacks_.size() >= kMeshObjectsMax) return xml.bad("too many slicestacks; merge them");
    stack_ = &stacks_[{part, *id}];
    stack_->bottom_mm = *z * unit_mm;
  } else if (event.name == "sliceref") {
    const std::string* id = event.attribute("slicestackid");
    const std::string* path = event.attribute("slicepath");
    if (id == nullptr || path == nullptr || stack_ == nullptr) {
      return xml.bad("a sliceref without slicestackid or slicepath; export the part again");
    }
    if (stack_->referred.size() >= kMeshObjectsMax) return xml.bad("too many references");
    stack_->referred.push_back({without_slash(*path), *id});
  }
  return {};
}

std::string ThreeMfStacks::add(const ThreeMfItem& item, const std::vector<std::string>& parts,
                               std::vector<SlicedItem>& items) const {
  const auto& [part, object] = item.key;
  const std::string& id = sliced_.at(item.key);
  const auto found = stacks_.find({part, id});
  if (found == stacks_.end()) return "slicestack '" + shown(id) + "' is not in the file";
  const auto& m = item.transform.m;
  if (m[2] != 0 || m[5] != 0 || m[6] != 0 || m[7] != 0 || m[8] != 1) {
    return "object '" + shown(object) +
           "' is slices, and the build tilts them or changes their height; export its full mesh";
  }
  if (items.size() >= kSlicedItemsMax) {
    return "more than " + std::to_string(kSlicedItemsMax) + " items that are slices; merge them";
  }
  SlicedItem sliced{found->second.referred, found->second.bottom_mm, item.transform};
  if (sliced.stacks.empty()) {
    sliced.stacks.push_back({parts[static_cast<std::size_t>(part)], id});
  }
  items.push_back(std::move(sliced));
  return {};
}

}  // namespace host
