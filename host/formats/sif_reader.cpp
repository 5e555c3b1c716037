#include "host/formats/sif_reader.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "host/formats/format_limits.h"  // kNestingMax
#include "host/formats/number_text.h"    // parse_integer
#include "host/formats/sif_body.h"       // read_sif_body
#include "host/formats/sif_scanner.h"    // SifScanner
#include "host/formats/text_scanner.h"   // shown

namespace host {
namespace {

using core::Result;
using core::Status;
using Token = SifScanner::Token;
using Kind = ShellNode::Kind;

// A set of shells before it becomes part of the tree: either only shells, or a node.
struct ShellSet {
  std::vector<Shell> shells;
  std::optional<std::size_t> node;

  [[nodiscard]] bool empty() const { return shells.empty() && !node; }
};

class SifReader {
 public:
  explicit SifReader(InputFile file)
      : tree_(std::make_unique<ShellTree>()), scanner_(std::move(file)) {
    tree_->name = scanner_.name();
  }

  [[nodiscard]] Result<std::unique_ptr<ShellTree>> read() {
    if (Status opened = scanner_.expect_open(); !opened.ok()) return opened.error();
    const Result<std::string> magic = scanner_.keyword();
    if (!magic.ok()) return magic.error();
    const Result<double> version = scanner_.number("a version number");
    if (!version.ok()) return version.error();
    const Result<double> release = scanner_.number("a release number");
    if (!release.ok()) return release.error();
    old_ = version.value() < 2;
    tree_->format = old_ ? "SIF 1.0" : "SIF 2.0";
    Result<ShellSet> all = sets("", 0);
    if (!all.ok()) return all.error();
    if (all.value().empty()) return scanner_.bad("there is no solid in the file; export it again");
    const Result<std::size_t> root = node_of(std::move(all).value());
    if (!root.ok()) return root.error();
    return std::move(tree_);
  }

 private:
  // The union of the sets up to the closing parenthesis. Reads properties of the file, too.
  [[nodiscard]] Result<ShellSet> sets(const std::string& within, int depth) {
    std::vector<ShellSet> found;
    bool empty_input = false;
    while (true) {
      const Result<Token> token = scanner_.next();
      if (!token.ok()) return token.error();
      if (token.value() == Token::kClose) break;
      if (token.value() != Token::kOpen) return scanner_.unexpected(token.value(), "'(' or ')'");
      const Result<std::string> keyword = scanner_.keyword();
      if (!keyword.ok()) return keyword.error();
      Result<std::optional<ShellSet>> set = form(keyword.value(), depth);
      if (!set.ok()) return set.error();
      if (!set.value()) continue;
      empty_input = empty_input || set.value()->empty();
      if (!set.value()->empty() || within == "difference") {
        found.push_back(*std::move(set).value());
      }
    }
    if (within == "intersection") {
      if (empty_input) return ShellSet();
      return combined(Kind::kIntersection, std::move(found));
    }
    if (within != "difference" || found.empty()) return united(std::move(found));
    ShellSet first = std::move(found.front());
    found.erase(found.begin());
    Result<ShellSet> rest = united(std::move(found));
    if (!rest.ok() || rest.value().empty() || first.empty()) return rest.ok() ? first : rest;
    std::vector<ShellSet> both;
    both.push_back(std::move(first));
    both.push_back(std::move(rest).value());
    return combined(Kind::kDifference, std::move(both));
  }

  // Nullopt if the form is no shell set; it has been read then.
  [[nodiscard]] Result<std::optional<ShellSet>> form(const std::string& keyword, int depth) {
    if (depth > kNestingMax) {
      return scanner_.bad("more than " + std::to_string(kNestingMax) +
                          " forms within one another; repair the file");
    }
    const auto wrapped = [](Result<ShellSet> set) -> Result<std::optional<ShellSet>> {
      if (!set.ok()) return set.error();
      return std::optional<ShellSet>(std::move(set).value());
    };
    if (old_ && keyword == "body") return wrapped(body());
    if (keyword == "units") {
      if (Status read = units(); !read.ok()) return read.error();
      return std::optional<ShellSet>();
    }
    if (keyword == "shell") return wrapped(shell());
    if (keyword == "solid" || keyword == "lump" || keyword == "constellation" ||
        keyword == "union" || keyword == "intersection" || keyword == "difference") {
      return wrapped(sets(keyword, depth + 1));
    }
    if (Status skipped = skip(keyword); !skipped.ok()) return skipped.error();
    return std::optional<ShellSet>();
  }

  [[nodiscard]] Status skip(const std::string& keyword) {
    const bool known =
        keyword == "color" || keyword == "desired_accuracy" || keyword == "coord_precision";
    if (!known && tree_->warnings.empty()) {
      tree_->warnings.push_back(tree_->name + ": '" + shown(keyword) +
                                "' was not understood and left out");
    }
    return scanner_.skip_form();
  }

  [[nodiscard]] Status units() {
    if (old_) {
      const Result<double> metres = scanner_.number("a unit in metres");
      if (!metres.ok()) return metres.error();
      if (!(metres.value() > 0)) return scanner_.bad("a unit of no length; correct the file");
      unit_mm_ = metres.value() * 1'000;
    } else {
      const Result<std::string> unit = scanner_.keyword();
      if (!unit.ok()) return unit.error();
      const bool mm = unit.value() == "mm";
      if (!mm && unit.value() != "inches" && unit.value() != "inch") {
        return scanner_.unexpected(Token::kWord, "'mm' or 'inches'");
      }
      unit_mm_ = mm ? 1 : 25.4;
    }
    return scanner_.expect_close();
  }

  [[nodiscard]] Result<ShellSet> body() {
    if (!unit_mm_) return no_units();
    const MeshStore::Key key{1, std::to_string(shells_++)};
    if (Status read = read_sif_body(scanner_, *unit_mm_, key, tree_->store); !read.ok()) {
      return read.error();
    }
    return ShellSet{{{key, false}}, std::nullopt};
  }

  [[nodiscard]] core::Error no_units() const {
    return scanner_.bad("a solid before (units …), so that sizes mean nothing; add them");
  }

  [[nodiscard]] Result<ShellSet> shell() {
    if (!unit_mm_) return no_units();
    Shell shell{{0, std::to_string(shells_++)}, false};
    if (!tree_->store.start_object(shell.key)) return scanner_.bad("too many shells; merge them");
    vertices_.clear();
    lowest_ = UINT32_MAX;
    highest_ = 0;
    if (Status read = shell_forms(0); !read.ok()) return read.error();
    const std::size_t count = tree_->store.vertices();
    const bool from_one = highest_ == count && lowest_ > 0;
    if (lowest_ != UINT32_MAX && highest_ >= count && !from_one) {
      return scanner_.bad("a triangle's corner " + std::to_string(highest_) +
                          " is no vertex of its shell's " + std::to_string(count) +
                          "; export the file again");
    }
    if (from_one && lowest_ != UINT32_MAX) tree_->store.count_from_one();
    shell.reversed = volume(from_one ? 1 : 0) < 0;
    triangles_.clear();
    if (shell.reversed && !std::exchange(told_reversed_, true)) {
      tree_->warnings.push_back(tree_->name + ": shells that are inside out were turned");
    }
    return ShellSet{{shell}, std::nullopt};
  }

  // Reads vertices, triangles, surface and its contents, in any order.
  [[nodiscard]] Status shell_forms(int depth) {
    if (depth > kNestingMax) return scanner_.bad("too many forms within one another");
    while (true) {
      const Result<Token> token = scanner_.next();
      if (!token.ok()) return token.error();
      if (token.value() == Token::kClose) return {};
      if (token.value() != Token::kOpen) return scanner_.unexpected(token.value(), "'(' or ')'");
      const Result<std::string> keyword = scanner_.keyword();
      if (!keyword.ok()) return keyword.error();
      Status taken;
      if (keyword.value() == "v") {
        taken = vertex();
      } else if (keyword.value() == "t") {
        taken = triangle();
      } else if (keyword.value() == "vertices" || keyword.value() == "triangles" ||
                 keyword.value() == "surface") {
        taken = shell_forms(depth + 1);
      } else {
        taken = skip(keyword.value());
      }
      if (!taken.ok()) return taken;
    }
  }

  [[nodiscard]] Status vertex() {
    PointMm point{};
    for (double& coordinate : point) {
      const Result<double> value = scanner_.number("a coordinate");
      if (!value.ok()) return value.error();
      coordinate = value.value() * *unit_mm_;
    }
    if (Status kept = vertices_.push_back(point); !kept.ok()) return kept;
    if (Status kept = tree_->store.add_vertex(point); !kept.ok()) return kept;
    return scanner_.expect_close();
  }

  [[nodiscard]] Status triangle() {
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& corner : corners) {
      const Result<Token> token = scanner_.next();
      if (!token.ok()) return token.error();
      const std::optional<std::int64_t> index = parse_integer(scanner_.word());
      if (!index) return scanner_.unexpected(token.value(), "a vertex's number");
      if (*index < 0 || static_cast<std::uint64_t>(*index) > tree_->store.vertices()) {
        return scanner_.bad("a triangle's corner " + std::to_string(*index) +
                            " is no vertex of its shell's " +
                            std::to_string(tree_->store.vertices()) + "; export the file again");
      }
      corner = static_cast<std::uint32_t>(*index);
      lowest_ = std::min(lowest_, corner);
      highest_ = std::max(highest_, corner);
    }
    if (Status kept = triangles_.push_back(corners); !kept.ok()) return kept;
    if (Status kept = tree_->store.add_triangle(corners); !kept.ok()) return kept;
    return scanner_.expect_close();
  }

  // Six times the shell's volume, in mm³; positive if its triangles face outwards.
  [[nodiscard]] double volume(std::uint32_t first) const {
    double sum = 0;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      const auto corners = triangles_.at(i);
      const PointMm a = vertices_.at(corners[0] - first), b = vertices_.at(corners[1] - first);
      const PointMm c = vertices_.at(corners[2] - first);
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum;
  }

  [[nodiscard]] Result<std::size_t> node_of(ShellSet set) {
    if (set.node) return *set.node;
    if (tree_->operands.size() >= kOperandsMax) {
      return scanner_.bad("booleans of more than " + std::to_string(kOperandsMax) +
                          " meshes, more than fit; unite some of them before");
    }
    tree_->operands.push_back(std::move(set.shells));
    tree_->nodes.push_back({Kind::kOperand, tree_->operands.size() - 1, {}});
    return tree_->nodes.size() - 1;
  }

  // Shells without booleans stay one mesh: the union of their insides.
  [[nodiscard]] Result<ShellSet> united(std::vector<ShellSet> sets) {
    ShellSet plain;
    std::vector<ShellSet> all;
    for (ShellSet& set : sets) {
      if (set.node) {
        all.push_back(std::move(set));
      } else {
        plain.shells.insert(plain.shells.end(), set.shells.begin(), set.shells.end());
      }
    }
    if (all.empty()) return plain;
    if (!plain.shells.empty()) all.push_back(std::move(plain));
    return combined(Kind::kUnion, std::move(all));
  }

  [[nodiscard]] Result<ShellSet> combined(Kind kind, std::vector<ShellSet> sets) {
    if (sets.empty()) return ShellSet();
    if (sets.size() == 1) return std::move(sets.front());
    ShellNode node{kind, 0, {}};
    for (ShellSet& set : sets) {
      const Result<std::size_t> input = node_of(std::move(set));
      if (!input.ok()) return input.error();
      node.inputs.push_back(input.value());
    }
    tree_->nodes.push_back(std::move(node));
    return ShellSet{{}, tree_->nodes.size() - 1};
  }

  std::unique_ptr<ShellTree> tree_;
  SifScanner scanner_;
  bool old_ = false;
  std::optional<double> unit_mm_;
  std::int64_t shells_ = 0;
  // The shell that is being read.
  MappedArray<PointMm> vertices_;
  MappedArray<std::array<std::uint32_t, 3>> triangles_;
  std::uint32_t lowest_ = 0;
  std::uint32_t highest_ = 0;
  bool told_reversed_ = false;
};

class PlainTriangles : public TriangleSource {
 public:
  explicit PlainTriangles(std::unique_ptr<ShellTree> tree) : tree_(std::move(tree)) {
    warnings_ = tree_->warnings;
    place();
  }

  [[nodiscard]] std::string format() const override { return tree_->format; }

  [[nodiscard]] Result<bool> rewind() override {
    tree_->store.clear_items();
    place();
    facets_ = 0;
    return true;
  }

  [[nodiscard]] Result<std::optional<core::Triangle>> next() override {
    if (error_.empty()) {
      MeshStore::Next next = tree_->store.next();
      error_ = next.error;
      if (error_.empty() && !next.triangle && facets_ == 0) {
        error_ = "there is no triangle in the file; export the part again";
      }
      if (next.triangle) ++facets_;
      if (error_.empty()) return next.triangle;
    }
    return core::Error{core::ErrorCode::kBadPart, tree_->name + ": " + error_};
  }

 private:
  void place() {
    for (const Shell& shell : tree_->operands[0]) {
      if (error_.empty()) error_ = tree_->store.add_item(shell.key, {}, shell.reversed);
    }
  }

  std::unique_ptr<ShellTree> tree_;
  std::string error_;
};

}  // namespace

Result<std::unique_ptr<ShellTree>> read_sif(InputFile file) {
  return SifReader(std::move(file)).read();
}

std::unique_ptr<TriangleSource> plain_triangles(std::unique_ptr<ShellTree> tree) {
  return std::make_unique<PlainTriangles>(std::move(tree));
}

}  // namespace host
