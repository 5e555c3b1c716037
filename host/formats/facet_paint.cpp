#include "host/formats/facet_paint.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

using Corner = std::array<double, 3>;

struct Piece {
  std::array<Corner, 3> corners;
  int depth = 0;
};

std::optional<unsigned> digit_of(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  return std::nullopt;
}

// A node of the tree.
struct Node {
  unsigned halved = 0;  // edges; 0: a leaf
  unsigned first = 0;   // corner, of a piece that is split
  FacetPaint paint = FacetPaint::kNone;
};

// Reads nodes from the text's end on.
class NodeReader {
 public:
  explicit NodeReader(std::string_view text) : rest_(text) {}

  // Nothing: the text has ended, or is none.
  [[nodiscard]] std::optional<Node> next() {
    const std::optional<unsigned> digit = take();
    if (!digit) return std::nullopt;
    Node node{*digit & 3U, *digit >> 2U, FacetPaint::kNone};
    if (node.halved == 3) node.first %= 3;  // of no meaning
    if (node.halved > 0) return node.first < 3 ? std::optional(node) : std::nullopt;
    if (node.first == 3) {
      node.paint = FacetPaint::kUnknown;
      if (!take()) return std::nullopt;
    } else {
      node.paint = static_cast<FacetPaint>(node.first);
    }
    return node;
  }

  [[nodiscard]] bool ended() const { return rest_.empty(); }

 private:
  [[nodiscard]] std::optional<unsigned> take() {
    if (rest_.empty()) return std::nullopt;
    const std::optional<unsigned> digit = digit_of(rest_.back());
    rest_.remove_suffix(1);
    return digit;
  }

  std::string_view rest_;
};

Corner middle(const Corner& a, const Corner& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

// Appends the children of a piece, in the reverse of the file's order.
void split(const Piece& piece, const Node& node, std::vector<Piece>& into) {
  const Corner& a = piece.corners[node.first];
  const Corner& b = piece.corners[(node.first + 1) % 3];
  const Corner& c = piece.corners[(node.first + 2) % 3];
  const auto add = [&](const Corner& p, const Corner& q, const Corner& r) {
    into.push_back({{p, q, r}, piece.depth + 1});
  };
  if (node.halved == 1) {
    const Corner bc = middle(b, c);
    add(a, b, bc);
    add(bc, c, a);
  } else if (node.halved == 2) {
    const Corner ab = middle(a, b), ac = middle(a, c);
    add(a, ab, ac);
    add(ab, b, ac);
    add(b, c, ac);
  } else {
    const Corner ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    add(a, ab, ca);
    add(ab, b, bc);
    add(bc, c, ca);
    add(ab, bc, ca);
  }
}

core::Triangle snapped(const Piece& piece) {
  core::Triangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& at = piece.corners[i];
    triangle.corners[i] = {static_cast<std::int32_t>(std::llround(at[0])),
                           static_cast<std::int32_t>(std::llround(at[1])), std::llround(at[2])};
  }
  return triangle;
}

}  // namespace

bool is_paint(std::string_view text) {
  NodeReader nodes(text);
  std::vector<int> depths{0};  // of the pieces to come
  while (!depths.empty()) {
    const int depth = depths.back();
    depths.pop_back();
    const std::optional<Node> node = nodes.next();
    if (!node || depth > kPaintDepthMax) return false;
    if (node->halved > 0) depths.insert(depths.end(), node->halved + 1, depth + 1);
  }
  return nodes.ended();
}

core::Status each_painted_piece(std::string_view text, const core::Triangle& corners,
                                const PieceTaker& take) {
  Piece whole;
  for (std::size_t i = 0; i < 3; ++i) {
    const core::Vertex& at = corners.corners[i];
    whole.corners[i] = {static_cast<double>(at.x), static_cast<double>(at.y),
                        static_cast<double>(at.z)};
  }
  NodeReader nodes(text);
  std::vector<Piece> to_come{whole};
  while (!to_come.empty()) {
    const Piece piece = to_come.back();
    to_come.pop_back();
    const std::optional<Node> node = nodes.next();
    RIND_CHECK(node.has_value());
    if (node->halved > 0) {
      split(piece, *node, to_come);
    } else if (node->paint != FacetPaint::kNone) {
      if (core::Status taken = take(snapped(piece), node->paint); !taken.ok()) return taken;
    }
  }
  return {};
}

}  // namespace host
