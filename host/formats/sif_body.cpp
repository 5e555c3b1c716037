#include "host/formats/sif_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "host/formats/format_limits.h"  // kNestingMax
#include "host/formats/sif_reader.h"     // kNamedVerticesMax
#include "host/formats/text_scanner.h"   // shown

namespace host {
namespace {

using core::Result;
using core::Status;
using Token = SifScanner::Token;
using Key = MeshStore::Key;

// Shapes of SIF 1.0 other than single triangles.
constexpr std::array<std::string_view, 14> kRefused{"face", "contour", "path",    "tm",   "tab",
                                                    "tac",  "taf",     "tar",     "tsb",  "tsf",
                                                    "tsr",  "tf",      "include", "NURBS"};

class BodyReader {
 public:
  BodyReader(SifScanner& scanner, double unit_mm, MeshStore& store)
      : scanner_(scanner), unit_mm_(unit_mm), store_(store) {}

  [[nodiscard]] Status read(const Key& key) {
    if (Status all = geometry(key, 0); !all.ok()) return all;
    // Which objects contain which is known only now.
    for (const auto& [holder, pieces] : pieces_) {
      if (!store_.start_object(holder)) {
        return scanner_.bad("'" + shown(holder.second) + "' is there twice; repair the file");
      }
      for (const Piece& piece : pieces) {
        store_.add_component(piece.key, piece.transform, piece.reversed);
      }
    }
    return {};
  }

 private:
  struct Piece {
    Key key;
    Transform transform;
    bool reversed = false;
  };

  // Reads forms up to the closing parenthesis, as pieces of `holder`.
  [[nodiscard]] Status geometry(const Key& holder, int depth) {
    if (depth > kNestingMax) return scanner_.bad("too many forms within one another");
    pieces_.try_emplace(holder);
    while (true) {
      const Result<Token> token = scanner_.next();
      if (!token.ok()) return token.error();
      if (token.value() == Token::kClose) return {};
      if (token.value() != Token::kOpen) return scanner_.unexpected(token.value(), "'(' or ')'");
      const Result<std::string> keyword = scanner_.keyword();
      if (!keyword.ok()) return keyword.error();
      if (Status taken = form(keyword.value(), holder, depth); !taken.ok()) return taken;
    }
  }

  [[nodiscard]] Status form(const std::string& keyword, const Key& holder, int depth) {
    if (keyword == "v") return vertex();
    if (keyword == "t" || keyword == "f") return facet(holder);
    if (keyword == "lump" || keyword == "shell" || keyword == "surface") {
      return geometry(holder, depth + 1);
    }
    if (keyword == "def" || keyword == "inst") {
      const Result<std::string> kind = scanner_.keyword();
      if (!kind.ok()) return kind.error();
      if (kind.value() != "surface") return scanner_.unexpected(Token::kWord, "'surface'");
      const Result<std::string> id = scanner_.keyword();
      if (!id.ok()) return id.error();
      const Key key{2, id.value()};
      if (keyword == "inst") return instance(key, holder);
      if (pieces_.contains(key)) {
        return scanner_.bad("surface '" + shown(id.value()) + "' is defined twice");
      }
      facets_of_ = nullptr;
      Status read = geometry(key, depth + 1);
      facets_of_ = nullptr;
      return read;
    }
    if (std::find(kRefused.begin(), kRefused.end(), keyword) != kRefused.end()) {
      return scanner_.bad("'" + shown(keyword) +
                          "' is not supported; export the part as triangles, (t …)");
    }
    return scanner_.skip_form();
  }

  [[nodiscard]] Status vertex() {
    const Result<std::string> id = scanner_.keyword();
    if (!id.ok()) return id.error();
    PointMm point{};
    for (double& coordinate : point) {
      const Result<double> value = scanner_.number("a coordinate");
      if (!value.ok()) return value.error();
      coordinate = value.value() * unit_mm_;
    }
    if (vertices_.size() >= kNamedVerticesMax) {
      return scanner_.bad("more than " + std::to_string(kNamedVerticesMax) +
                          " named vertices, more than fit; export SIF 2.0 or STL");
    }
    vertices_[id.value()] = point;
    return scanner_.expect_close();
  }

  // Three corners, or a convex facet of more.
  [[nodiscard]] Status facet(const Key& holder) {
    std::vector<PointMm> corners;
    while (true) {
      const Result<Token> token = scanner_.next();
      if (!token.ok()) return token.error();
      if (token.value() == Token::kClose) break;
      if (token.value() == Token::kOpen) {
        if (Status skipped = scanner_.skip_form(); !skipped.ok()) return skipped;
        continue;
      }
      const auto found = vertices_.find(scanner_.word());
      if (token.value() != Token::kWord || found == vertices_.end()) {
        return scanner_.bad("'" + shown(scanner_.word()) +
                            "' is no vertex that stands before; export the file again");
      }
      if (corners.size() >= kWordBytesMax) return scanner_.bad("a facet of too many corners");
      corners.push_back(found->second);
    }
    if (corners.size() < 3) return scanner_.bad("a facet of fewer than three corners");
    if (Status started = start_facets(holder); !started.ok()) return started;
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const auto first = static_cast<std::uint32_t>(store_.vertices());
      for (const std::size_t corner : {std::size_t{0}, i - 1, i}) {
        if (Status kept = store_.add_vertex(corners[corner]); !kept.ok()) return kept;
      }
      if (Status kept = store_.add_triangle({first, first + 1, first + 2}); !kept.ok()) return kept;
    }
    return {};
  }

  // Consecutive facets are one object of the store; a definition between them ends it.
  [[nodiscard]] Status start_facets(const Key& holder) {
    const Key* known = &pieces_.find(holder)->first;
    if (facets_of_ == known && store_.vertices() < (std::size_t{1} << 31)) return {};
    const Key key{3, std::to_string(chunks_++)};
    if (!store_.start_object(key)) return scanner_.bad("too many surfaces; merge them");
    pieces_[holder].push_back({key, {}, false});
    facets_of_ = known;
    return {};
  }

  [[nodiscard]] Status instance(const Key& key, const Key& holder) {
    Piece piece{key, {}, false};
    while (true) {
      const Result<Token> token = scanner_.next();
      if (!token.ok()) return token.error();
      if (token.value() == Token::kClose) break;
      if (token.value() != Token::kOpen) return scanner_.unexpected(token.value(), "'(' or ')'");
      const Result<std::string> keyword = scanner_.keyword();
      if (!keyword.ok()) return keyword.error();
      if (Status taken = transform(keyword.value(), piece); !taken.ok()) return taken;
    }
    std::vector<Piece>& pieces = pieces_[holder];
    if (++instances_ > kMeshInstancesMax) return scanner_.bad("too many instances; merge them");
    pieces.push_back(std::move(piece));
    return {};
  }

  [[nodiscard]] Status transform(const std::string& keyword, Piece& piece) {
    constexpr std::string_view kAxes = "xyz";
    const char kind = keyword.empty() ? '?' : keyword[0];
    const char what = keyword.size() == 2 ? keyword[1] : '?';
    const std::size_t axis = kAxes.find(what);
    const bool one = axis != std::string_view::npos;
    const bool known = (kind == 't' && (one || what == 'v')) || (kind == 'r' && one) ||
                       (kind == 's' && (one || what == 'v' || what == 'a')) ||
                       (kind == 'm' && (one || what == 'o'));
    if (!known) {
      return scanner_.bad("transform '" + shown(keyword) +
                          "' is not supported; place the surface "
                          "with tv, rx, ry, rz, sv, mx, my, mz");
    }
    std::array<double, 3> values{};
    const std::size_t count = kind == 'm' ? 0 : what == 'v' ? 3 : 1;
    for (std::size_t i = 0; i < count; ++i) {
      const Result<double> value = scanner_.number("a number");
      if (!value.ok()) return value.error();
      values[i] = value.value();
    }
    Transform step;
    if (kind == 't') {
      for (std::size_t i = 0; i < count; ++i) step.m[9 + (one ? axis : i)] = values[i] * unit_mm_;
    } else if (kind == 'r') {
      const double angle = values[0] * std::numbers::pi / 180;
      const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
      step.m[3 * a + a] = step.m[3 * b + b] = std::cos(angle);
      step.m[3 * a + b] = std::sin(angle);
      step.m[3 * b + a] = -std::sin(angle);
    } else if (kind == 's') {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!one || i == axis) step.m[4 * i] = what == 'v' ? values[i] : values[0];
      }
    } else if (one) {
      step.m[4 * axis] = -1;
    } else {
      piece.reversed = !piece.reversed;
    }
    piece.transform = piece.transform.then(step);
    return scanner_.expect_close();
  }

  SifScanner& scanner_;
  double unit_mm_;
  MeshStore& store_;
  std::unordered_map<std::string, PointMm> vertices_;
  std::map<Key, std::vector<Piece>> pieces_;
  const Key* facets_of_ = nullptr;  // owner of the facets in the store's last object; in pieces_
  std::int64_t chunks_ = 0;
  std::size_t instances_ = 0;
};

}  // namespace

Status read_sif_body(SifScanner& scanner, double unit_mm, const Key& key, MeshStore& store) {
  return BodyReader(scanner, unit_mm, store).read(key);
}

}  // namespace host
