// The short way from an archive to its files, or to why it has none.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/models/zip.h"
#include "tests/core/faults.h"
#include "tests/core/models/zip_files.h"

namespace tia::test {

using ZipFiles = std::vector<std::pair<std::string, std::string>>;

// Of a copy that ends where its memory does, so that a read beyond it is seen.
inline ZipFiles unzipped(const std::string& archive, Faults& faults, const ZipLimits& limits = {}) {
  const std::vector<std::uint8_t> bytes(archive.begin(), archive.end());
  ZipFiles files;
  for (const UnpackedFile& file : unpack_zip(bytes, limits, faults))
    files.emplace_back(file.path, std::string(file.bytes.begin(), file.bytes.end()));
  return files;
}
inline ZipFiles unzipped(const std::string& archive) {
  Faults faults;
  ZipFiles files = unzipped(archive, faults);
  faults.raise();
  return files;
}
inline void expect_zip_refused(const std::string& archive, const std::vector<Expected>& expected,
                               const ZipLimits& limits = {}) {
  Faults faults;
  EXPECT_EQ(unzipped(archive, faults, limits), ZipFiles());
  expect_faults(faults.list(), expected);
}
// With one fault at a path.
inline void expect_zip_item_refused(const ZipItem& item, const std::string& pointer,
                                    const std::string& allowed) {
  Faults faults;
  EXPECT_EQ(unzipped(zip_of({zip_item("a.obj", "v"), item}), faults), ZipFiles());
  ASSERT_EQ(faults.list().size(), 1U) << pointer << ": " << allowed;
  const Fault& fault = faults.list()[0];
  EXPECT_EQ(fault.pointer, pointer);
  EXPECT_EQ(fault.kind, FaultKind::malformed) << describe(fault);
  EXPECT_NE(fault.allowed.find(allowed), std::string::npos) << describe(fault);
}
inline void expect_zip_broken(const std::string& archive, const std::string& got) {
  Faults faults;
  EXPECT_EQ(unzipped(archive, faults), ZipFiles());
  ASSERT_EQ(faults.list().size(), 1U);
  EXPECT_EQ(faults.list()[0].allowed, "a whole ZIP archive");
  EXPECT_NE(describe(faults.list()[0]).find(got), std::string::npos) << describe(faults.list()[0]);
}

inline const std::string four_corners = "v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\n";
inline const ZipFiles small_zip_files{
    {"a.obj", four_corners}, {"b/c.png", "not packed"}, {"b/empty", ""}};
inline std::string small_zip() {
  return zip_of({zip_item("a.obj", four_corners), zip_item("b/c.png", "not packed", false),
                 zip_item("b/empty", "", false)});
}

}  // namespace tia::test
