#include "host/output/qoi_writer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/check.h"

namespace host {
namespace {

// The first byte of each kind of chunk; the last two are whole bytes, the others' upper two bits.
constexpr std::uint32_t kIndex = 0x00, kSmallStep = 0x40, kStep = 0x80, kRun = 0xC0;
constexpr std::uint32_t kOpaque = 0xFE, kWhole = 0xFF;
constexpr std::uint32_t kRunMax = 62;

struct Pixel {
  std::uint8_t red = 0, green = 0, blue = 0, opacity = 0;
  bool operator==(const Pixel&) const = default;

  [[nodiscard]] std::size_t place() const {
    return (std::size_t{3} * red + std::size_t{5} * green + std::size_t{7} * blue +
            std::size_t{11} * opacity) %
           64;
  }
};

// From one byte to another, the shorter way around: -128 … 127.
int step(std::uint8_t from, std::uint8_t to) {
  return static_cast<std::int8_t>(static_cast<std::uint8_t>(to - from));
}

bool is_within(int value, int least, int greatest) { return value >= least && value <= greatest; }

class QoiStream {
 public:
  explicit QoiStream(std::string& file) : file_(file) {}

  void add(Pixel pixel) {
    if (pixel == last_) {
      if (++run_ == kRunMax) end_run();
      return;
    }
    end_run();
    Pixel& known = known_[pixel.place()];
    if (known == pixel) {
      put(kIndex | static_cast<std::uint32_t>(pixel.place()));
    } else {
      known = pixel;
      put_change(pixel);
    }
    last_ = pixel;
  }

  void end_run() {
    if (run_ > 0) put(kRun | (run_ - 1));
    run_ = 0;
  }

 private:
  void put(std::uint32_t byte) { file_ += static_cast<char>(byte); }

  void put_change(Pixel pixel) {
    const int red = step(last_.red, pixel.red), green = step(last_.green, pixel.green);
    const int blue = step(last_.blue, pixel.blue);
    const auto shifted = [](int value, int by) { return static_cast<std::uint32_t>(value + by); };
    if (pixel.opacity != last_.opacity) {
      put(kWhole);
    } else if (is_within(red, -2, 1) && is_within(green, -2, 1) && is_within(blue, -2, 1)) {
      return put(kSmallStep | shifted(red, 2) << 4 | shifted(green, 2) << 2 | shifted(blue, 2));
    } else if (is_within(green, -32, 31) && is_within(red - green, -8, 7) &&
               is_within(blue - green, -8, 7)) {
      put(kStep | shifted(green, 32));
      return put(shifted(red - green, 8) << 4 | shifted(blue - green, 8));
    } else {
      put(kOpaque);
    }
    for (const std::uint8_t byte : {pixel.red, pixel.green, pixel.blue}) put(byte);
    if (pixel.opacity != last_.opacity) put(pixel.opacity);
  }

  std::string& file_;
  Pixel last_{0, 0, 0, 255};
  std::array<Pixel, 64> known_{};
  std::uint32_t run_ = 0;
};

void append_number(std::uint32_t number, std::string& bytes) {
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xFFU);
}

}  // namespace

std::string qoi_of(const RgbaPicture& picture) {
  RIND_CHECK(picture.width >= 1 && picture.height >= 1);
  std::string file = "qoif";
  append_number(static_cast<std::uint32_t>(picture.width), file);
  append_number(static_cast<std::uint32_t>(picture.height), file);
  file += std::string_view("\x04\0", 2);  // four channels, sRGB
  QoiStream stream(file);
  const std::vector<std::uint8_t>& bytes = picture.bytes;
  for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
    stream.add({bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]});
  }
  stream.end_run();
  file += std::string_view("\0\0\0\0\0\0\0\x01", 8);
  return file;
}

}  // namespace host
