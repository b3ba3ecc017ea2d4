#include "core/film/jpeg.h"

#include <jpeglib.h>

#include <csetjmp>
#include <new>

namespace tia {
namespace {

constexpr int jpeg_quality = 90;
static_assert(longest_jpeg_side == JPEG_MAX_DIMENSION);

/// JpegErrors: libjpeg's way out, which else ends the program.
struct JpegErrors {
  jpeg_error_mgr manager{};
  std::jmp_buf back{};
};

[[noreturn]] void give_up(j_common_ptr codec) {
  std::longjmp(reinterpret_cast<JpegErrors*>(codec->err)->back, 1);
}

/// JpegFile: the bytes, as libjpeg fills them.
struct JpegFile {
  jpeg_destination_mgr manager{};
  std::string& bytes;

  explicit JpegFile(std::string& to) : bytes(to) {}
  void offer_from(std::size_t used) {
    manager.next_output_byte = reinterpret_cast<JOCTET*>(bytes.data()) + used;
    manager.free_in_buffer = bytes.size() - used;
  }
};

JpegFile& file_of(j_compress_ptr codec) { return *reinterpret_cast<JpegFile*>(codec->dest); }

void begin_file(j_compress_ptr codec) { file_of(codec).offer_from(0); }

// No exception may pass through libjpeg.
boolean grow_file(j_compress_ptr codec) {
  JpegFile& file = file_of(codec);
  const std::size_t used = file.bytes.size();
  bool has_grown = true;
  try {
    file.bytes.resize(2 * used);
  } catch (const std::bad_alloc&) {
    has_grown = false;
  }
  if (!has_grown) give_up(reinterpret_cast<j_common_ptr>(codec));
  file.offer_from(used);
  return TRUE;
}

void end_file(j_compress_ptr codec) {
  JpegFile& file = file_of(codec);
  file.bytes.resize(file.bytes.size() - file.manager.free_in_buffer);
}

void write_rows(const Image8& image, jpeg_compress_struct& codec) {
  codec.image_width = static_cast<JDIMENSION>(image.width);
  codec.image_height = static_cast<JDIMENSION>(image.height);
  codec.input_components = 3;
  codec.in_color_space = JCS_RGB;
  jpeg_set_defaults(&codec);
  jpeg_set_quality(&codec, jpeg_quality, TRUE);
  codec.dct_method = JDCT_ISLOW;
  codec.comp_info[0].h_samp_factor = codec.comp_info[0].v_samp_factor = 1;
  jpeg_start_compress(&codec, TRUE);
  while (codec.next_scanline < codec.image_height) {
    auto* row = const_cast<JSAMPROW>(image.rgb.data()) +
                std::size_t{3} * codec.image_width * codec.next_scanline;
    jpeg_write_scanlines(&codec, &row, 1);
  }
  jpeg_finish_compress(&codec);
}

// Nothing here, and nothing below it, has a destructor that the way out would pass by.
bool write_jpeg(const Image8& image, JpegFile& file) {
  jpeg_compress_struct codec{};
  JpegErrors errors;
  codec.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = give_up;
  if (setjmp(errors.back) != 0) {
    jpeg_destroy_compress(&codec);
    return false;
  }
  jpeg_create_compress(&codec);
  file.manager.init_destination = begin_file;
  file.manager.empty_output_buffer = grow_file;
  file.manager.term_destination = end_file;
  codec.dest = &file.manager;
  write_rows(image, codec);
  jpeg_destroy_compress(&codec);
  return true;
}

}  // namespace

std::string encode_jpeg(const Image8& image) {
  std::string bytes(image.rgb.size() / 8 + 4096, '\0');
  JpegFile file(bytes);
  if (!write_jpeg(image, file)) throw std::bad_alloc();  // nothing else can fail
  return bytes;
}

}  // namespace tia
