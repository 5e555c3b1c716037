// The formats of thumbnails, for settings.
#pragma once

namespace host {

enum class ThumbnailFormat {
  kPng,
  kQoi,
};

}  // namespace host
