#include "core/video/webp_animation.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <new>
#include <string>

namespace tia {
namespace {

constexpr int effort = 1;  // of 0 to 9: others are slower and hardly smaller

void must(int succeeded) {
  if (succeeded == 0) throw std::bad_alloc();  // nothing else can fail
}

/// WebpFrame: a picture as libwebp has it.
struct WebpFrame {
  WebPPicture picture{};
  WebpFrame(int width, int height) {
    must(WebPPictureInit(&picture));
    picture.use_argb = 1;
    picture.width = width;
    picture.height = height;
  }
  ~WebpFrame() { WebPPictureFree(&picture); }
  WebpFrame(const WebpFrame&) = delete;
  WebpFrame& operator=(const WebpFrame&) = delete;
};

}  // namespace

struct WebpAnimation::Encoder {
  const int width, height;
  WebPConfig config{};
  WebPAnimEncoder* made = nullptr;

  Encoder(int w, int h) : width(w), height(h) {
    WebPAnimEncoderOptions options;
    must(WebPAnimEncoderOptionsInit(&options));
    must(WebPConfigInit(&config));
    must(WebPConfigLosslessPreset(&config, effort));
    config.exact = 1;  // also what colour is where nothing is seen
    made = WebPAnimEncoderNew(width, height, &options);
    must(static_cast<int>(made != nullptr));
  }
  ~Encoder() { WebPAnimEncoderDelete(made); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void add(WebpFrame& frame, std::int64_t at_ms) const {
    must(WebPAnimEncoderAdd(made, &frame.picture, static_cast<int>(at_ms), &config));
  }
};

WebpAnimation::WebpAnimation(int width, int height)
    : encoder_(std::make_unique<Encoder>(width, height)) {}
WebpAnimation::~WebpAnimation() = default;

void WebpAnimation::add(const std::uint8_t* codes, bool has_alpha, std::int64_t at_ms) {
  WebpFrame frame(encoder_->width, encoder_->height);
  must(has_alpha ? WebPPictureImportRGBA(&frame.picture, codes, 4 * frame.picture.width)
                 : WebPPictureImportRGB(&frame.picture, codes, 3 * frame.picture.width));
  encoder_->add(frame, at_ms);
}

std::string WebpAnimation::finish(std::int64_t end_ms) {
  must(WebPAnimEncoderAdd(encoder_->made, nullptr, static_cast<int>(end_ms), nullptr));
  WebPData file;
  WebPDataInit(&file);
  must(WebPAnimEncoderAssemble(encoder_->made, &file));
  const std::unique_ptr<WebPData, void (*)(WebPData*)> freed(&file, WebPDataClear);
  return {reinterpret_cast<const char*>(file.bytes), file.size};
}

std::string webp_encoder() {
  const auto version = static_cast<unsigned>(WebPGetEncoderVersion());
  return "libwebp " + std::to_string(version >> 16U) + '.' + std::to_string(version >> 8U & 0xFFU) +
         '.' + std::to_string(version & 0xFFU);
}

}  // namespace tia
