// The compressors of all that is compressed here.
#pragma once

struct libdeflate_compressor;

namespace tia {

/// Compressor: libdeflate's, level 2, lent while this lives. Its tables are 656 KiB, so that they
/// are made for those who compress at once, not for each thread that ever does, and some are kept.
class Compressor {
 public:
  /// Errors: std::bad_alloc.
  Compressor();
  ~Compressor();
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  libdeflate_compressor* get() const { return lent_; }

 private:
  libdeflate_compressor* lent_;
};

}  // namespace tia
