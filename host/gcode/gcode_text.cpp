#include "host/gcode/gcode_text.h"

#include <vector>

namespace host {
namespace {

class PlainText final : public GcodeText {
 public:
  explicit PlainText(const FileBytes& bytes) : bytes_(bytes), piece_(kTextPieceBytes) {}

  core::Result<std::string_view> next() override {
    from_ = to_;
    const core::Result<std::size_t> read = bytes_.read(from_, piece_.data(), piece_.size());
    if (!read.ok()) return read.error();
    const std::string_view text(piece_.data(), read.value());
    hash_ = hash_of(text, hash_);
    to_ += static_cast<std::int64_t>(text.size());
    return text;
  }
  core::Status go_to(const TextPlace& place) override {
    to_ = place.block;
    return {};
  }
  [[nodiscard]] TextPlace place_in(std::size_t byte) const override {
    return {from_ + static_cast<std::int64_t>(byte), 0};
  }
  [[nodiscard]] const std::string& metadata() const override { return metadata_; }
  [[nodiscard]] std::int64_t bytes_read() const override { return to_; }
  [[nodiscard]] std::uint64_t hash() const override { return hash_; }

 private:
  const FileBytes& bytes_;
  std::vector<char> piece_;
  std::int64_t from_ = 0;
  std::int64_t to_ = 0;
  std::uint64_t hash_ = kHashStart;
  std::string metadata_;
};

}  // namespace

std::unique_ptr<GcodeText> plain_text(const FileBytes& bytes) {
  return std::make_unique<PlainText>(bytes);
}

}  // namespace host
