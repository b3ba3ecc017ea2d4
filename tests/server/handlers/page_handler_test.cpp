// The page and its files: what web/ holds, each with its type and ETag, from memory.
#include <libdeflate.h>

#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "server/stores/assets.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

namespace fs = std::filesystem;

const std::string& web() {
  static const std::string folder = std::string(TIA_SOURCE_DIR) + "/web";
  return folder;
}

// The gallery's files are answered as /scenes/NAME and /models/NAME.
bool of_the_gallery(std::string_view path) {
  return path.starts_with("/scenes/") || path.starts_with("/models/");
}

TEST(Assets, AreTheFilesOfWebByteForByte) {
  std::set<std::string> files, embedded;
  for (const auto& entry : fs::recursive_directory_iterator(web())) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && !name.starts_with('.') && !name.ends_with('~') &&
        name != "README.md")
      files.insert(std::string("/") + fs::relative(entry.path(), web()).string());
  }
  for (const Asset& asset : assets()) {
    embedded.emplace(asset.path);
    EXPECT_TRUE(asset.bytes == file_bytes(web() + std::string(asset.path))) << asset.path;
  }
  EXPECT_EQ(embedded, files);
  EXPECT_TRUE(embedded.contains("/index.html"));
}

TEST(Page, EveryFileHasItsTypeAndAnEtagOfItsOwn) {
  const std::map<std::string, std::string> types{{".html", "text/html; charset=utf-8"},
                                                 {".css", "text/css; charset=utf-8"},
                                                 {".js", "text/javascript; charset=utf-8"},
                                                 {".svg", "image/svg+xml"},
                                                 {".json", "application/json"},
                                                 {".png", "image/png"}};
  std::set<std::string> etags;
  std::size_t pages = 0;
  for (const Asset& asset : assets()) {
    if (of_the_gallery(asset.path)) continue;
    SCOPED_TRACE(asset.path);
    const Response response = host().get(std::string(asset.path));
    EXPECT_EQ(response.status, 200);
    EXPECT_TRUE(response.body == asset.bytes);
    EXPECT_EQ(response.content_type, types.at(fs::path(asset.path).extension().string()));
    const std::string etag = header(response, "ETag").value_or("");
    EXPECT_THAT(etag, testing::MatchesRegex("\"[^\"]+\""));  // strong
    etags.insert(etag);
    ++pages;
  }
  EXPECT_EQ(etags.size(), pages);
}

TEST(Page, IsIndexHtml) {
  const Response page = host().get("/"), file = host().get("/index.html");
  EXPECT_EQ(page.status, 200);
  EXPECT_TRUE(page.body == file.body);
  EXPECT_EQ(page.content_type, file.content_type);
  EXPECT_EQ(header(page, "ETag"), header(file, "ETag"));
}

TEST(Page, IsNotSentAgainToWhoHasIt) {
  for (const char* path : {"/", "/style.css"}) {
    const std::string etag = header(host().get(path), "ETag").value();
    for (const std::string& seen : {etag, "W/" + etag, "\"other\", " + etag}) {
      SCOPED_TRACE(seen);
      const Response response = host().get(path, {{"If-None-Match", seen}});
      EXPECT_EQ(response.status, 304);
      EXPECT_EQ(response.body, "");
      EXPECT_EQ(header(response, "ETag"), etag);
    }
    EXPECT_EQ(host().get(path, {{"if-none-match", etag}}).status, 304);
  }
}

TEST(Page, IsNotSentAgainToWhoHasAny) {  // RFC 9110, 13.1.2
  EXPECT_EQ(host().get("/", {{"If-None-Match", "*"}}).status, 304);
}

TEST(Page, IsSentToWhoHasAnother) {
  const std::string other = header(host().get("/main.js"), "ETag").value();
  for (const std::string& seen : {other, std::string("\"\""), std::string("\"other\"")}) {
    const Response response = host().get("/", {{"If-None-Match", seen}});
    EXPECT_EQ(response.status, 200);
    EXPECT_FALSE(response.body.empty());
  }
}

TEST(Page, IsAskedForAgainEachTime) {
  EXPECT_EQ(header(host().get("/"), "Cache-Control"), "no-cache");  // but 304 costs nothing
}

// ---- compressed -----------------------------------------------------------------------------

// The bytes of a gzip file that opens to `size` bytes; "" where it does not.
std::string unzipped(std::string_view file, std::size_t size) {
  std::string bytes(size, '\0');
  const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  const auto result = libdeflate_gzip_decompress(decompressor.get(), file.data(), file.size(),
                                                 bytes.data(), size, nullptr);
  return result == LIBDEFLATE_SUCCESS ? bytes : "";
}

Response zipped(const std::string& path, Headers headers = {}) {
  headers.emplace_back("Accept-Encoding", "gzip, deflate, br");
  return host().get(path, headers);
}

TEST(Page, GoesCompressedToWhoTakesIt) {
  for (const Asset& asset : assets()) {
    if (of_the_gallery(asset.path)) continue;
    const std::string path(asset.path);
    SCOPED_TRACE(path);
    const Response plain = host().get(path), response = zipped(path);
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.content_type, plain.content_type);
    EXPECT_FALSE(header(plain, "Content-Encoding"));
    ASSERT_FALSE(asset.gzip.empty());  // all that there is, is text of some length
    EXPECT_EQ(header(response, "Content-Encoding"), "gzip");
    EXPECT_LT(response.body.size(), plain.body.size());
    EXPECT_TRUE(unzipped(response.body, plain.body.size()) == plain.body);
    EXPECT_EQ(header(response, "Vary"), "Accept-Encoding");
    EXPECT_EQ(header(plain, "Vary"), "Accept-Encoding");
  }
}

TEST(Page, GoesAsItIsToWhoDoesNot) {
  for (const char* accept : {"", "br", "gzip;q=0", "identity"}) {
    const Response response = host().get("/", {{"Accept-Encoding", accept}});
    EXPECT_FALSE(header(response, "Content-Encoding")) << accept;
    EXPECT_TRUE(response.body == find_asset("/index.html")->bytes) << accept;
  }
}

TEST(Page, EachCodingHasATagOfItsOwn) {  // RFC 9110, 8.8.3.3
  const std::string plain = header(host().get("/"), "ETag").value();
  const std::string coded = header(zipped("/"), "ETag").value();
  EXPECT_THAT(coded, testing::MatchesRegex("\"[^\"]+\""));
  EXPECT_NE(coded, plain);
  const Response again = zipped("/", {{"If-None-Match", coded}});
  EXPECT_EQ(again.status, 304);
  EXPECT_EQ(header(again, "ETag"), coded);
  EXPECT_EQ(header(again, "Vary"), "Accept-Encoding");
  EXPECT_EQ(header(again, "Cache-Control"), "no-cache");
  EXPECT_EQ(zipped("/", {{"If-None-Match", plain}}).status, 200);
  EXPECT_EQ(host().get("/", {{"If-None-Match", coded}}).status, 200);
}

TEST(Page, AnUnknownFileIs404) {
  for (const char* path : {"/doc", "/style", "/style.css2", "/index.htm", "/scenes/thesis.png"})
    EXPECT_EQ(host().get(path).status, 404) << path;
}

}  // namespace
}  // namespace tia::test
