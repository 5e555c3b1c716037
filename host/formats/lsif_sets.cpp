#include "host/formats/lsif_sets.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/booleans/boolean.h"       // intersect, subtract
#include "core/units.h"                  // kUnitsPerMm
#include "host/formats/format_limits.h"  // kNestingMax, kLayerPointsMax
#include "host/formats/number_text.h"    // parse_integer

namespace host {

using core::Region;
using core::Result;
using core::Status;
using Token = SifScanner::Token;

void LsifSets::start_layer() {
  vertices_.clear();
  points_ = 0;
}

bool LsifSets::is_set(const std::string& keyword) {
  return keyword == "union" || keyword == "intersection" || keyword == "difference" ||
         keyword == "nested1d" || keyword == "contour";
}

Status LsifSets::take_form(const std::string& keyword) {
  if (keyword == "v") return vertex();
  if (!is_set(keyword)) return skip(keyword);
  const Result<Region> region = set(keyword, 0);
  if (!region.ok()) return region.error();
  if (const std::string cause = sets_.add(region.value()); !cause.empty()) {
    return scanner_.bad(cause);
  }
  return {};
}

Result<Region> LsifSets::finish_layer() { return sets_.take(core::FillRule::kPositive); }

Status LsifSets::skip(const std::string& keyword) {
  if (keyword != "color" && keyword != "contours_offset" && skipped_forms_++ == 0) {
    first_skipped_ = shown(keyword);
  }
  return scanner_.skip_form();
}

Status LsifSets::count_point() {
  if (++points_ <= kLayerPointsMax) return {};
  return scanner_.bad("a layer of more than " + std::to_string(kLayerPointsMax) +
                      " points, which is more than fits; simplify the part");
}

Status LsifSets::vertex() {
  const Result<Token> token = scanner_.next();
  if (!token.ok()) return token.error();
  const std::optional<std::int64_t> id = parse_integer(scanner_.word());
  if (!id) return scanner_.unexpected(token.value(), "a vertex's number");
  const Result<double> x = scanner_.number("a coordinate");
  if (!x.ok()) return x.error();
  const Result<double> y = scanner_.number("a coordinate");
  if (!y.ok()) return y.error();
  if (Status counted = count_point(); !counted.ok()) return counted;
  const double x_mm = x.value() * unit_mm_, y_mm = y.value() * unit_mm_;
  const std::optional<core::Point> point = snapped(x_mm, y_mm);
  if (!point) return scanner_.bad(too_far(x_mm, y_mm));
  vertices_[*id] = *point;
  return scanner_.expect_close();
}

Status LsifSets::contour(Turn turn, ContourGatherer& into) {
  if (const std::string cause = into.start(); !cause.empty()) return scanner_.bad(cause);
  while (true) {
    const Result<Token> token = scanner_.next();
    if (!token.ok()) return token.error();
    if (token.value() == Token::kClose) break;
    if (token.value() == Token::kOpen) {
      const Result<std::string> keyword = scanner_.keyword();
      if (!keyword.ok()) return keyword.error();
      Status taken = keyword.value() == "v" ? vertex() : skip(keyword.value());
      if (!taken.ok()) return taken;
      continue;
    }
    const std::optional<std::int64_t> id = parse_integer(scanner_.word());
    if (!id) return scanner_.unexpected(token.value(), "a vertex's number or ')'");
    const auto found = vertices_.find(*id);
    if (found == vertices_.end()) {
      return scanner_.bad("vertex " + std::to_string(*id) +
                          " is not in this layer; export the file again");
    }
    if (Status counted = count_point(); !counted.ok()) return counted;
    if (const std::string cause = into.add(found->second); !cause.empty()) {
      return scanner_.bad(cause);
    }
  }
  into.end(turn);
  return {};
}

// The first contour is the outer one, further ones are holes; a nested form is an island.
Status LsifSets::nested(int depth, ContourGatherer& into) {
  if (depth > kNestingMax) {
    return scanner_.bad("more than " + std::to_string(kNestingMax) + " forms within one another");
  }
  Turn turn = Turn::kCounterClockwise;
  while (true) {
    const Result<Token> token = scanner_.next();
    if (!token.ok()) return token.error();
    if (token.value() == Token::kClose) return {};
    if (token.value() != Token::kOpen) return scanner_.unexpected(token.value(), "'(' or ')'");
    const Result<std::string> keyword = scanner_.keyword();
    if (!keyword.ok()) return keyword.error();
    Status taken;
    if (keyword.value() == "contour") {
      taken = contour(turn, into);
      turn = Turn::kClockwise;
    } else if (keyword.value() == "nested1d") {
      taken = nested(depth + 1, into);
    } else {
      taken = keyword.value() == "v" ? vertex() : skip(keyword.value());
    }
    if (!taken.ok()) return taken;
  }
}

Result<Region> LsifSets::set(const std::string& keyword, int depth) {
  if (depth > kNestingMax) {
    return scanner_.bad("more than " + std::to_string(kNestingMax) + " forms within one another");
  }
  ContourGatherer contours;
  if (keyword == "contour") {
    if (Status read = contour(Turn::kAsWritten, contours); !read.ok()) return read.error();
    return contours.take(core::FillRule::kNonZero);
  }
  if (keyword == "nested1d") {
    if (Status read = nested(depth, contours); !read.ok()) return read.error();
    return contours.take(core::FillRule::kPositive);
  }
  return boolean(keyword, depth);
}

// The operands of a union, or those that a difference subtracts, are united in one operation.
Result<Region> LsifSets::boolean(const std::string& keyword, int depth) {
  std::optional<Region> first;
  ContourGatherer united;
  while (true) {
    const Result<Token> token = scanner_.next();
    if (!token.ok()) return token.error();
    if (token.value() == Token::kClose) break;
    if (token.value() != Token::kOpen) return scanner_.unexpected(token.value(), "'(' or ')'");
    const Result<std::string> operand = scanner_.keyword();
    if (!operand.ok()) return operand.error();
    if (!is_set(operand.value())) {
      Status taken = operand.value() == "v" ? vertex() : skip(operand.value());
      if (!taken.ok()) return taken.error();
      continue;
    }
    Result<Region> region = set(operand.value(), depth + 1);
    if (!region.ok()) return region;
    if (keyword == "intersection" && first) {
      first = core::intersect(*first, region.value());
    } else if (keyword != "union" && !first) {
      first = std::move(region).value();
    } else if (const std::string cause = united.add(region.value()); !cause.empty()) {
      return scanner_.bad(cause);
    }
  }
  if (keyword == "intersection") return first.value_or(Region());
  Region all = united.take(core::FillRule::kPositive);
  if (keyword == "union") return all;
  return first ? core::subtract(*first, all) : Region();
}

}  // namespace host
