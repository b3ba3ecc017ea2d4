// GET and POST /still: a model in, its picture out.
#include "server/stores/digest.h"
#include "tests/core/models/zip_files.h"
#include "tests/server/still_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST_F(Stills, AreTransparentPngsOf512Pixels) {
  const Response picture = still("&samples=1");
  ASSERT_EQ(picture.status, 200) << picture.body;
  EXPECT_EQ(picture.content_type, "image/png");
  const Png png = read_png(picture.body);
  EXPECT_EQ(png.width, 512);
  EXPECT_EQ(png.height, 512);
  EXPECT_EQ(png.rgba.size(), 4U * 512 * 512);
}

// What POST /render is given of a still.
std::string body_of(const std::string& scene) {
  return R"({"width":40,"height":30,"scene":)" + scene + "}";
}

TEST_F(Stills, AreWhatRenderDrawsOfTheirScene) {
  for (const std::string query :
       {"", "&integrator=whitted", "&studio=sun&ground=floor&background=0.2,0.3,0.4",
        "&turntable=3&ground=none", "&turntable=2&columns=1&integrator=whitted&background=1",
        "&orbit=-70,10&fov=0&zoom=2", "&integrator=normal", "&noise=0.2&exposure=1",
        "&fit.min=0,0,0&fit.max=1,1,1&up=z", "&integrator=whitted&threshold=0.1&transfer=linear"}) {
    SCOPED_TRACE(query);
    const std::string all = quick + query;
    const Response picture = still(all);
    ASSERT_EQ(picture.status, 200) << picture.body;
    const Response again = own_.post("/render", body_of(scene(all)));
    ASSERT_EQ(again.status, 200) << again.body;
    EXPECT_TRUE(picture.body == again.body);
    EXPECT_EQ(header(picture, "ETag"), header(again, "ETag"));
  }
}

TEST_F(Stills, TellTheModelByItsIdAlone) {
  const Value told = parse_json(scene(""));
  EXPECT_EQ(to_json(at(told, "objects")), R"([{"id":")" + id_ + R"(","type":"model"}])");
}

TEST_F(Stills, AreTheSameByIdAndAsABody) {
  for (const std::string query : {"", "&studio=dark", "&as=scene"}) {
    const Response by_id = still(quick + query), as_body = sent(quick.substr(1) + query);
    ASSERT_EQ(as_body.status, 200) << as_body.body;
    EXPECT_TRUE(by_id.body == as_body.body);
    const auto address = header(as_body, "Content-Location");
    ASSERT_TRUE(address);
    EXPECT_TRUE(own_.get(*address).body == by_id.body) << *address;
  }
  Host other;
  const Response first =
      other.post("/still?main=box.obj" + quick, form_of_files(box_files), form_type);
  EXPECT_TRUE(first.body == still(quick).body);
  EXPECT_EQ(other.head("/models/" + id_).status, 200);
}

TEST_F(Stills, AreKeptLikeAllPictures) {
  const Response first = still(quick), second = still(quick);
  EXPECT_THAT(*header(first, "Cache-Status"), HasSubstr("stored"));
  EXPECT_EQ(header(second, "Cache-Status"), "Tia; hit");
  EXPECT_TRUE(first.body == second.body);
  const std::string target = "/still?model=" + id_ + quick;
  const Headers known{{"If-None-Match", *header(first, "ETag")}};
  EXPECT_EQ(own_.get(target, known).status, 304);
  EXPECT_EQ(own_.head(target).status, 200);
  EXPECT_EQ(own_.head(target + "&as=scene").status, 200);
}

TEST_F(Stills, DrawThemselvesAgainFromTheirRecipe) {
  const Response picture = still(quick);
  EXPECT_TRUE(own_.post("/render", picture.body, "image/png").body == picture.body);
}

TEST_F(Stills, OfABudgetTellTheAddressOfWhatWasReached) {
  const Response picture = still("&width=8&height=8&max_rays=1000000");
  ASSERT_EQ(picture.status, 200) << picture.body;
  const auto address = header(picture, "Content-Location");
  ASSERT_TRUE(address);
  EXPECT_THAT(*address, StartsWith("/still?model=" + id_));
  EXPECT_TRUE(own_.get(*address).body == picture.body);
  EXPECT_EQ(header(sent("width=8&height=8&max_rays=1000000"), "Content-Location"), std::nullopt);
}

// ---- what is seen -------------------------------------------------------------------------------

// From the front the box is 2 wide and 4 high, its front side nearest: that touches the frame.
TEST_F(Stills, FillNineTenthsOfThePicture) {
  const Png png = this->png("&integrator=object&orbit=0,0&width=100&height=100&background=0");
  const std::string black(3, '\0');
  int top = 100, bottom = -1, left = 100, right = -1;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x)
      if (png.rgb.substr(static_cast<std::size_t>(3 * (100 * y + x)), 3) != black)
        top = std::min(top, y), bottom = std::max(bottom, y), left = std::min(left, x),
        right = std::max(right, x);
  EXPECT_NEAR(top, 5, 1);
  EXPECT_NEAR(bottom, 94, 1);
  EXPECT_NEAR(left, 27.5, 1);
  EXPECT_NEAR(right, 71.5, 1);
}

// In a furnace of 1 what is white and matt is 1.
TEST_F(Stills, OfAWhiteBodyInNeutralLightAreOne) {
  const Response picture =
      still("&studio=neutral&background=0&format=pfm&width=16&height=16&zoom=3&max_depth=64");
  ASSERT_EQ(picture.status, 200) << picture.body;
  // Of 64 samples a pixel's error is some 0.01, the mean's of 256 pixels a sixteenth of that.
  const Pixels<float> pixels = decode_pfm(picture.body);
  double sum = 0;
  for (const float light : pixels.rgb) {
    EXPECT_NEAR(light, 1, 0.06);
    sum += light;
  }
  EXPECT_NEAR(sum / static_cast<double>(pixels.rgb.size()), 1, 0.003);
}

// Over a colour a transparent still is the one before that colour. A headlight's is at most 1: none
// of it is cut off.
TEST_F(Stills, OverAColourAreThoseBeforeIt) {
  const std::string usual = "&width=48&height=48&samples=8&transfer=linear&studio=headlight";
  const Png clear = png(usual), before = png(usual + "&background=0.25,0.5,0.75");
  const double color[] = {0.25, 0.5, 0.75};
  int between = 0;
  for (std::size_t i = 0; i < 48U * 48; ++i) {
    const double alpha = static_cast<unsigned char>(clear.rgba[4 * i + 3]) / 255.0;
    between += alpha > 0 && alpha < 1;
    for (std::size_t c = 0; c < 3; ++c) {
      const double own = static_cast<unsigned char>(clear.rgba[4 * i + c]);
      EXPECT_NEAR(alpha * own + (1 - alpha) * 255 * color[c],
                  static_cast<unsigned char>(before.rgb[3 * i + c]), 1.5);
    }
  }
  EXPECT_GT(between, 20) << "edges";
}

// ---- what is wrong ------------------------------------------------------------------------------

TEST_F(Stills, FaultsNameTheirParameter) {
  const std::pair<const char*, const char*> rows[] = {
      {"&orbit=0,91", "/orbit/1"},
      {"&orbit=0", "/orbit"},
      {"&zoom=0", "/zoom"},
      {"&fov=0.5", "/fov"},
      {"&studio=night", "/studio"},
      {"&ground=sea", "/ground"},
      {"&background=red", "/background"},
      {"&background=1,-1,0", "/background/1"},
      {"&camera=0", "/camera"},
      {"&camera=front", "/camera"},
      {"&camera=0&zoom=2", "/camera"},
      {"&hide=wheel", "/hide/0"},
      {"&hide=white", "/hide"},
      {"&variant=red", "/variant"},
      {"&animation=0", "/animation"},
      {"&time=1", "/time"},
      {"&scene=7", "/scene"},
      {"&up=w", "/up"},
      {"&fit.min=0,0,0", "/fit/max"},
      {"&fit.min=0,0,0&fit.max=1,0,1", "/fit/max"},
      {"&width=0", "/width"},
      {"&crop=0,0,9999,1", "/crop"},
      {"&as=film", "/as"},
      {"&samples=0", "/samples"},
      {"&format=pfm", "/format"},
      {"&format=hdr&background=transparent", "/format"},
      {"&key=a", "/key"},
      {"&light=1,2,3", "/light"},
      {"&ambient=1", "/ambient"},
      {"&id=0", "/id"},
      {"&colour=red", "/colour"},
      {"&integrator=whitted&noise=0.1", "/noise"},
      {"&main=box.obj", "/main"},
      {"&turntable=65", "/turntable"},
      {"&turntable=2&camera=0", "/turntable"},
      {"&columns=2", "/columns"},
      {"&turntable=2&columns=3", "/columns"},
      {"&turntable=2&crop=0,0,9,9", "/crop"},
      {"&turntable=2&budget_ms=1000", "/budget_ms"},
      {"&fit.min=9e8,0,0&fit.max=1e9,1e9,1e9", "/fit"}};
  for (const auto& [query, pointer] : rows) {
    SCOPED_TRACE(query);
    const Response refused = still(query);
    EXPECT_EQ(refused.status, 422) << refused.body;
    EXPECT_EQ(problem_of(refused).errors.at(0).pointer, pointer) << refused.body;
  }
  EXPECT_EQ(still("&format=pfm&background=0.5" + quick).status, 200);
  EXPECT_EQ(still("&format=pfm&integrator=depth" + quick).status, 200);
}

TEST_F(Stills, OfAModelThatIsNotKeptAre422) {
  for (const std::string& id : {sha256_hex("none"), std::string("../etc/passwd")}) {
    const Response refused = own_.get("/still?model=" + url_encode(id));
    EXPECT_EQ(refused.status, 422);
    EXPECT_EQ(problem_of(refused).type, "/problems/missing");
    EXPECT_EQ(only_error(refused).pointer, "/model");
    EXPECT_EQ(only_error(refused).got, Value(id));
  }
  EXPECT_EQ(only_error(own_.get("/still")).pointer, "/model");
}

TEST_F(Stills, OfABodyThatIsNoModelAreRefusedAsByPostModels) {
  EXPECT_EQ(own_.post("/still", "nothing").status, 415);
  EXPECT_EQ(own_.post("/still", "v 0 0 0\nv 1 0 0\nv 0 1 x\nf 1 2 3\n").status, 422);
  EXPECT_EQ(own_.post("/still", R"({"asset":{"version":"2.0"}})").status, 422);
  EXPECT_EQ(own_.post("/still?model=" + id_, stl_text()).status, 422);
  Config config;
  config.max_model_bytes = 100;
  Host narrow(config);
  EXPECT_EQ(narrow.post("/still", stl_text()).status, 413);
}

TEST_F(Stills, AreTakenAsAFileAndAsAZip) {
  const std::string zip =
      zip_of({zip_item("box.obj", box_files[0].second), zip_item("m.mtl", box_files[1].second)});
  EXPECT_TRUE(own_.post("/still?" + quick.substr(1), zip, "application/zip").body ==
              still(quick).body);
  EXPECT_EQ(own_.post("/still?" + quick.substr(1), stl_text(), "model/stl").status, 200);
}

TEST_F(Stills, AreOfTheFormatThatAcceptPrefers) {
  const std::string target = "/still?model=" + id_ + quick;
  EXPECT_EQ(own_.get(target + "&background=1", {{"Accept", "image/vnd.radiance"}}).content_type,
            "image/vnd.radiance");
  EXPECT_EQ(own_.get(target, {{"Accept", "text/html"}}).status, 406);
  EXPECT_EQ(own_.get(target + "&as=scene", {{"Accept", "image/png"}}).status, 406);
  EXPECT_EQ(own_.get(target + "&as=scene", {{"Accept", "application/json"}}).status, 200);
}

}  // namespace
}  // namespace tia::test
