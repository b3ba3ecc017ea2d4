// Which of several files is the model, and what a bundle's id is made of.
#include "core/models/bundle.h"

#include <gtest/gtest.h>

#include "core/models/paths.h"
#include "tests/core/faults.h"
#include "tests/core/models/file_bytes.h"

namespace tia {
namespace {

using test::Expected;

std::vector<ModelFile> files_named(const std::vector<std::string>& paths) {
  std::vector<ModelFile> files;
  for (const std::string& path : paths) files.push_back({path, {}});
  return files;
}
// The path of the main file.
std::string main_among(const std::vector<std::string>& paths, std::string_view wanted = "") {
  Faults faults;
  const std::size_t main = main_of(files_named(paths), wanted, faults);
  faults.raise();
  return paths.at(main);
}
void expect_no_main(const std::vector<std::string>& paths, std::string_view wanted,
                    const Expected& expected) {
  Faults faults;
  EXPECT_EQ(main_of(files_named(paths), wanted, faults), 0U);
  test::expect_faults(faults.list(), {expected});
}
std::vector<std::string> stripped(const std::vector<std::string>& paths) {
  std::vector<ModelFile> files = files_named(paths);
  strip_lone_folder(files);
  std::vector<std::string> left;
  for (const ModelFile& file : files) left.push_back(file.path);
  return left;
}
using Paths = std::vector<std::string>;

// ---- paths --------------------------------------------------------------------------------------

TEST(CleanPath, IsOneForAllNamesThatMeanTheSame) {
  Faults faults;
  for (const char* name : {"a/b.png", "./a/b.png", "a//b.png", "a\\b.png", "a/./b.png", "a/b.png/"})
    EXPECT_EQ(clean_path(name, faults), "a/b.png") << name;
  for (const char* name : {"é", "..a", "a..", "...", "a b", " ", "1:2", "über/日本.png", "~"})
    EXPECT_EQ(clean_path(name, faults), name);
  EXPECT_EQ(clean_path(std::string(longest_path, 'x'), faults), std::string(longest_path, 'x'));
  EXPECT_TRUE(faults.empty());
}

TEST(CleanPath, RefusesNamesThatMeanNoFileAmongThese) {
  const auto refused = [](const std::string& name, FaultKind kind, const std::string& allowed) {
    Faults faults;
    EXPECT_EQ(clean_path(name, faults), std::nullopt);
    ASSERT_EQ(faults.count(), 1U);
    EXPECT_EQ(faults.list()[0].kind, kind);
    EXPECT_NE(faults.list()[0].allowed.find(allowed), std::string::npos) << name;
  };
  for (const char* name : {"", ".", "./", "./."}) refused(name, FaultKind::malformed, "a file");
  for (const char* name : {"..", "../a", "a/..", "a/../b", "a\\..\\..\\b"})
    refused(name, FaultKind::malformed, "..");
  for (const char* name : {"/", "/a", "\\a", "//a/b", "c:/a", "C:a"})
    refused(name, FaultKind::malformed, "a relative path");
  for (const char* name : {"a\tb", "a\x7F", "\xC2\x85", "\x1B[2J"})
    refused(name, FaultKind::malformed, "control");
  for (const char* name : {"\xFF", "a\xC3", "\xED\xA0\x80", "\xC0\xAE\xC0\xAE/a"})
    refused(name, FaultKind::malformed, "UTF-8");
  refused(std::string(longest_path + 1, 'x'), FaultKind::limit, "1024 bytes");
}

TEST(Clutter, IsWhatMacosAdds) {
  for (const char* path : {".DS_Store", "a/.DS_Store", "__MACOSX/._a", "a/__MACOSX/b/c"})
    EXPECT_TRUE(is_clutter(path)) << path;
  for (const char* path : {"DS_Store", ".DS_Store/a", "a/__MACOSX", "__macosx.png", "._a"})
    EXPECT_FALSE(is_clutter(path)) << path;
}

// ---- the main file ------------------------------------------------------------------------------

TEST(MainOf, IsTheOnlyFileThatEndsAsModelsDo) {
  for (const char* model :
       {"m.gltf", "m.glb", "m.obj", "m.ply", "m.stl", "M.GLTF", "m.Obj", "a/.stl"})
    EXPECT_EQ(main_among({"a.png", model, "m.bin", "gltf", "glb.txt", "aobj"}), model);
}

TEST(MainOf, OfSeveralIsTheOneThatLiesHighest) {
  EXPECT_EQ(main_among({"parts/a.obj", "all.obj", "parts/b.obj"}), "all.obj");
  EXPECT_EQ(main_among({"a/parts/a.obj", "a/all.gltf", "b/c/d.obj", "top.png"}), "a/all.gltf");
  expect_no_main({"b.obj", "a.ply", "c/d.stl", "x.png"}, "",
                 {FaultKind::conflict, "/main", "3", "main = one of a.ply, b.obj, c/d.stl"});
}

TEST(MainOf, AFileThatCameAloneIsItWhateverItsName) {
  EXPECT_EQ(main_among({"model"}), "model");
  EXPECT_EQ(main_among({"a/b.png"}), "a/b.png");
}

TEST(MainOf, WithoutAModelIsMissing) {
  const Expected missing{FaultKind::missing, "/main", "", ".gltf, .glb, .obj, .ply or .stl"};
  expect_no_main({}, "", missing);
  expect_no_main({"a.png", "b.mtl"}, "", missing);
}

TEST(MainOf, WhatIsWantedCountsWhateverItsName) {
  EXPECT_EQ(main_among({"a.obj", "b.obj", "c"}, "b.obj"), "b.obj");
  EXPECT_EQ(main_among({"a.obj", "b.obj", "c"}, "c"), "c");
}

TEST(MainOf, WhatIsWantedMayLeaveOutTheLoneFolder) {
  const Paths paths{"chair/a.obj", "chair/b/a.obj", "chair/chair/b.obj"};
  EXPECT_EQ(main_among(paths, "a.obj"), "chair/a.obj");
  EXPECT_EQ(main_among(paths, "chair/a.obj"), "chair/a.obj");
  EXPECT_EQ(main_among(paths, "b/a.obj"), "chair/b/a.obj");
  EXPECT_EQ(main_among(stripped(paths), "b/a.obj"), "b/a.obj");
  // A path that means two files means the one that it means when the folder is off.
  const Paths both{"a/x.obj", "a/a/x.obj"};
  EXPECT_EQ(main_among(both, "a/x.obj"), "a/a/x.obj");
}

TEST(MainOf, WhatIsWantedAndDidNotComeIsUnknown) {
  expect_no_main({"chair.obj", "table.obj"}, "chair.opj",
                 {FaultKind::unknown_name, "/main", "\"chair.opj\"", "one of chair.obj, table.obj",
                  "chair.obj"});
  expect_no_main({"chair.obj"}, "x", {FaultKind::unknown_name, "/main", "\"x\"", "chair.obj"});
  expect_no_main({}, "x", {FaultKind::unknown_name, "/main", "\"x\"", ""});
}

// ---- the lone folder ----------------------------------------------------------------------------

TEST(LoneFolder, IsTakenOff) {
  EXPECT_EQ(stripped({"chair/chair.gltf", "chair/a.png"}), (Paths{"chair.gltf", "a.png"}));
  EXPECT_EQ(stripped({"a/b/c.obj", "a/b/d/e.png"}), (Paths{"c.obj", "d/e.png"}));
  EXPECT_EQ(stripped({"a/b.glb"}), (Paths{"b.glb"}));
}

TEST(LoneFolder, IsNoneWhereFilesLieBesideIt) {
  for (const Paths& paths : {Paths{}, Paths{"a"}, Paths{"a/b", "c"}, Paths{"a/b", "ab/c"},
                             Paths{"ab/c", "a/b"}, Paths{"chair/a", "chairs/b"}, Paths{"a", "a/b"}})
    EXPECT_EQ(stripped(paths), paths);
}

TEST(LoneFolder, IsTakenOffAtOnce) {
  const Paths once = stripped({"a/b/c/d.obj", "a/b/c/e/f.png"});
  EXPECT_EQ(once, (Paths{"d.obj", "e/f.png"}));
  EXPECT_EQ(stripped(once), once);
}

// ---- the id -------------------------------------------------------------------------------------

TEST(BundleText, IsCanonical) {
  EXPECT_EQ(bundle_text({{"b/wood.png", "02"}, {"a.gltf", "01"}}, "a.gltf"),
            R"({"files":{"a.gltf":"01","b/wood.png":"02"},"main":"a.gltf"})");
  EXPECT_EQ(bundle_text({{"a.gltf", "01"}, {"b/wood.png", "02"}}, "a.gltf"),
            bundle_text({{"b/wood.png", "02"}, {"a.gltf", "01"}}, "a.gltf"));
  // RFC 8785, section 3.2.3: by UTF-16 code units, so a pair of surrogates before U+FB33.
  EXPECT_EQ(bundle_text({{"\uFB33", "1"}, {"\U0001F600", "2"}, {"\"", "3"}}, "\""),
            "{\"files\":{\"\\\"\":\"3\",\"\U0001F600\":\"2\",\"\uFB33\":\"1\"},\"main\":\"\\\"\"}");
}

// ---- what came, as files ------------------------------------------------------------------------

TEST(FilesOf, AnArchiveAreItsFiles) {
  const std::vector<UnpackedFile> unpacked{{"a.obj", {'v', '\n'}}, {"b", {}}};
  const auto files = files_of(unpacked);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].path, "a.obj");
  EXPECT_EQ(files[0].bytes.data(), unpacked[0].bytes.data());
  EXPECT_EQ(test::text_of_file(files[0].bytes), "v\n");
  EXPECT_EQ(files[1].path, "b");
  EXPECT_TRUE(files[1].bytes.empty());
}

FormPart form_file(std::optional<std::string> filename, std::string_view bytes = "x") {
  return {"file", std::move(filename), "", test::file_bytes(bytes)};
}

TEST(FilesOf, AFormAreItsPartsWithAFileName) {
  Faults faults;
  const auto files =
      files_of({form_file("chair\\a.obj"), form_file(std::nullopt), form_file("", ""),
                form_file("chair/.DS_Store"), form_file("chair/empty.bin", "")},
               faults);
  EXPECT_TRUE(faults.empty());
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].path, "chair/a.obj");
  EXPECT_EQ(test::text_of_file(files[0].bytes), "x");
  EXPECT_EQ(files[1].path, "chair/empty.bin");
}

TEST(FilesOf, AFormRefusesPathsThatLeadOutOrComeTwice) {
  Faults faults;
  files_of({form_file("a/b"), form_file("../c"), form_file(""), form_file("./a/b")}, faults);
  test::expect_faults(faults.list(),
                      {{FaultKind::malformed, "/..~1c", "\"../c\"", "without \"..\""},
                       {FaultKind::malformed, "/", "\"\"", "names a file"},
                       {FaultKind::conflict, "/a~1b", "\"a/b\"", "each path once"}});
}

}  // namespace
}  // namespace tia
