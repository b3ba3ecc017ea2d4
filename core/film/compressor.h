// The thread's compressor, for all that is compressed here.
#pragma once

struct libdeflate_compressor;

namespace tia {

/// libdeflate's, level 2. Its tables are large: one for each thread, kept.
/// Errors: std::bad_alloc.
libdeflate_compressor& compressor();

}  // namespace tia
