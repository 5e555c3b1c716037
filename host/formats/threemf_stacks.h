// Where the slices of a 3MF's objects are (slice extension). They are read later
// (threemf_slices.h).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/result.h"               // Status
#include "host/formats/mesh_store.h"   // MeshStore
#include "host/formats/slice_stack.h"  // SlicedItem, StackPlace
#include "host/formats/threemf_cut.h"  // ThreeMfItem
#include "host/formats/xml_scanner.h"  // XmlEvent, XmlScanner

namespace host {

class ThreeMfStacks {
 public:
  // <slicestack> or <sliceref>, in the part of that number.
  [[nodiscard]] core::Status take(const XmlEvent& event, int part, double unit_mm,
                                  const XmlScanner& xml);

  // The object is slices: those of a stack of its part.
  void note(const MeshStore::Key& object, const std::string& stack) { sliced_[object] = stack; }
  [[nodiscard]] bool contains(const MeshStore::Key& object) const {
    return sliced_.contains(object);
  }

  // Adds the item, whose object contains() has. Returns why it can't be printed; empty if it can.
  // `parts`: names of the package's models, by number.
  [[nodiscard]] std::string add(const ThreeMfItem& item, const std::vector<std::string>& parts,
                                std::vector<SlicedItem>& items) const;

 private:
  struct Stack {
    double bottom_mm = 0;
    std::vector<StackPlace> referred;  // empty: it has slices of its own
  };

  std::map<MeshStore::Key, std::string> sliced_;
  std::map<MeshStore::Key, Stack> stacks_;
  Stack* stack_ = nullptr;  // the one that is being read
};

}  // namespace host
