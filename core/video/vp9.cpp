#include "core/video/vp9.h"

#include <vpx/vp8cx.h>
#include <vpx/vpx_encoder.h>

#include <new>

#include "core/video/ycbcr.h"

namespace tia {
namespace {

// How coarse numbers are, of 0 to 63; and how hard it tries, of 0 to 9: faster ones are larger.
constexpr int quantizer = 8, speed = 6;
constexpr unsigned most_between_keys = 128;

void must(vpx_codec_err_t result) {
  if (result != VPX_CODEC_OK) throw std::bad_alloc();  // nothing else can fail
}

vpx_codec_enc_cfg_t configuration(int width, int height) {
  vpx_codec_enc_cfg_t config{};
  must(vpx_codec_enc_config_default(vpx_codec_vp9_cx(), &config, 0));
  config.g_w = static_cast<unsigned>(width);
  config.g_h = static_cast<unsigned>(height);
  config.g_threads = 1;
  config.g_lag_in_frames = 0;  // a picture in, a frame out
  config.rc_end_usage = VPX_Q;
  config.rc_dropframe_thresh = 0;
  config.kf_max_dist = most_between_keys;
  return config;
}

// The planes as libvpx has them. They are not copied.
vpx_image_t image_of(YCbCr420& picture) {
  vpx_image_t image{};
  vpx_img_wrap(&image, VPX_IMG_FMT_I420, static_cast<unsigned>(picture.width),
               static_cast<unsigned>(picture.height), 1, picture.y.data());
  image.planes[VPX_PLANE_U] = picture.cb.data();
  image.planes[VPX_PLANE_V] = picture.cr.data();
  image.stride[VPX_PLANE_Y] = picture.width;
  image.stride[VPX_PLANE_U] = image.stride[VPX_PLANE_V] = picture.half_width();
  image.cs = VPX_CS_BT_709;
  image.range = VPX_CR_STUDIO_RANGE;
  return image;
}

}  // namespace

struct Vp9Encoder::Codec {
  vpx_codec_ctx_t context{};
  ~Codec() { vpx_codec_destroy(&context); }
};

Vp9Encoder::Vp9Encoder(int width, int height) : codec_(std::make_unique<Codec>()) {
  const vpx_codec_enc_cfg_t config = configuration(width, height);
  vpx_codec_ctx_t* context = &codec_->context;
  must(vpx_codec_enc_init(context, vpx_codec_vp9_cx(), &config, 0));
  must(vpx_codec_control(context, VP8E_SET_CPUUSED, speed));
  must(vpx_codec_control(context, VP8E_SET_CQ_LEVEL, quantizer));
  must(vpx_codec_control(context, VP8E_SET_ENABLEAUTOALTREF, 0));
  must(vpx_codec_control(context, VP9E_SET_COLOR_SPACE, VPX_CS_BT_709));
  must(vpx_codec_control(context, VP9E_SET_COLOR_RANGE, VPX_CR_STUDIO_RANGE));
}

Vp9Encoder::~Vp9Encoder() = default;

Vp9Frame Vp9Encoder::encode(const Image8& image) {
  YCbCr420 picture = ycbcr_of(image);
  const vpx_image_t planes = image_of(picture);
  vpx_codec_ctx_t* context = &codec_->context;
  must(vpx_codec_encode(context, &planes, frames_++, 1, 0, VPX_DL_REALTIME));
  Vp9Frame frame;
  vpx_codec_iter_t next = nullptr;
  while (const vpx_codec_cx_pkt_t* packet = vpx_codec_get_cx_data(context, &next)) {
    if (packet->kind != VPX_CODEC_CX_FRAME_PKT) continue;
    frame.bytes.append(static_cast<const char*>(packet->data.frame.buf), packet->data.frame.sz);
    frame.is_key = (packet->data.frame.flags & VPX_FRAME_IS_KEY) != 0;
  }
  return frame;
}

std::string vp9_encoder() { return std::string("libvpx ") + vpx_codec_version_str(); }

}  // namespace tia
