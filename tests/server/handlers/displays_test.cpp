// Pictures of several views over HTTP: where the views are in the whole, exact counts of rays, what
// files say of them, and what does not fit.
#include <cmath>
#include <cstdio>
#include <map>

#include "core/film/png_text.h"
#include "tests/core/models/zip_reading.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

// A ball and a floor, seen by a camera of those members.
std::string scene(const std::string& camera) {
  return R"("scene":{"background":[0.2,0.3,0.5],"camera":{)" + camera + R"(},"objects":[
    {"type":"sphere","center":[0.3,0.2,-5],"radius":1,"material":{"color":[0.9,0.4,0.2],"ambient":0.3}},
    {"type":"plane","point":[0,-1,0],"normal":[0,1,0],"material":{"ambient":0.2}}],
    "lights":[{"type":"point","position":[4,6,1]}]})";
}
Response drawn(const std::string& members, const std::string& camera) {
  const Response response = host().post("/render", "{" + members + "," + scene(camera) + "}");
  EXPECT_EQ(response.status, 200) << response.body;
  return response;
}
Pixels<float> pfm(const std::string& members, const std::string& camera) {
  return decode_pfm(drawn(R"("format":"pfm",)" + members, camera).body);
}
std::map<std::string, std::string> files_of(const std::string& archive) {
  const ZipFiles files = unzipped(archive);
  return {files.begin(), files.end()};
}
long long primary_of(const Response& response) {
  long long rays = 0;
  std::sscanf(header(response, "Tia-Rays").value_or("").c_str(), "primary=%lld", &rays);
  return rays;
}
const std::string size = R"("width":12,"height":12)";
const std::string quilt = R"("look_at":[0,0,-5],"display":{"type":"quilt","columns":3,"rows":2})";
const std::string wall = R"("look_at":[0,0,-5],"display":{"type":"modules","screen":[3,2],
    "modules":5,"pitch":0.5,"behind":1,"observer":{"distance":4},"columns":3})";

TEST(Displays, HaveAsManyRaysAsPixelsOfTheirViews) {
  const std::pair<std::string, int> cases[] = {
      {R"("display":{"type":"cube"})", 6 * 144},
      {R"("look_at":[0,0,-5],"display":{"type":"stereo"})", 2 * 144},
      {R"("look_at":[0,0,-5],"display":{"type":"stereo","layout":"anaglyph"})", 2 * 144},
      {R"("display":{"type":"omnistereo"})", 2 * 144},
      {quilt, 6 * 144},
      {quilt + R"(,"interlace":{"pitch":4})", 3 * 144},
      {wall, 5 * 144},
      // From x = 0.1 columns are seen for which a module is there: |1.25 x - 0.025| <= 1.25.
      {std::string(wall).replace(wall.find("\"screen\""), 0, "\"slice\":0.1,"), 8 * 12},
      {R"("look_at":[0,0,-5],"display":{"type":"two_plane","st":[2,2],
          "uv":{"columns":2,"rows":2,"spacing":0.1}})",
       4 * 144}};
  for (const auto& [camera, rays] : cases)
    EXPECT_EQ(primary_of(drawn(size, camera)), rays) << camera;
}

TEST(Displays, ACropIsCutOutOfTheWholeAndPlacesWithoutAViewShowNothing) {
  for (const std::string& camera : {quilt, wall, std::string(R"("display":{"type":"cube"})")}) {
    const auto whole = pfm(size, camera);
    EXPECT_EQ(std::pair(whole.width, whole.height), std::pair(36, 24));
    for (const auto& [x0, y0, x1, y1] :
         {std::array{5, 3, 30, 20}, {12, 12, 13, 13}, {25, 13, 36, 24}}) {
      const std::string crop = ",\"crop\":[" + std::to_string(x0) + ',' + std::to_string(y0) + ',' +
                               std::to_string(x1) + ',' + std::to_string(y1) + ']';
      EXPECT_TRUE(pfm(size + crop, camera) == whole.window(x0, y0, x1, y1)) << camera << crop;
    }
  }
  EXPECT_EQ(pfm(size, wall).at(30, 18, 1), 0.3F) << "the sixth place of five views";
}

TEST(Displays, TheViewInAQuiltIsThatOfTheCameraThatViewsJsonTells) {
  const auto files = files_of(drawn(size + R"(,"format":"zip")", quilt).body);
  ASSERT_EQ(files.size(), 7U);
  const Value told = parse_json(files.at("views.json"));
  const Value& view = (*at(told, "views").as<Value::Array>())[4];
  EXPECT_EQ(at(view, "file"), Value("view_4.png"));
  EXPECT_EQ(at(view, "column"), Value(1));
  EXPECT_EQ(at(view, "row"), Value(0)) << "the second row from below is the upper one";
  const auto vector = [&](const Value& v) {
    const auto& each = *v.as<Value::Array>();
    return Vec3d{*each[0].as<double>(), *each[1].as<double>(), *each[2].as<double>()};
  };
  const Value& window = at(view, "window");
  const Vec3d eye = vector(at(view, "eye")), center = vector(at(window, "center"));
  const auto text = [](const Vec3d& v) { return to_json(write_value(v)); };
  const auto alone =
      pfm(size, "\"location\":" + text(eye) + ",\"direction\":" + text(center - eye) +
                    ",\"right\":" + text(vector(at(window, "right"))) +
                    ",\"up\":" + text(vector(at(window, "up"))));
  const auto whole = pfm(size, quilt).window(12, 0, 24, 12);
  int different = 0;
  for (std::size_t i = 0; i < whole.rgb.size(); ++i)
    different += std::fabs(whole.rgb[i] - alone.rgb[i]) > 1e-5F;
  EXPECT_LE(different, 3) << "a pixel at an edge";
  EXPECT_TRUE(decode_png(files.at("view_4.png")) ==
              decode_png(drawn(size, quilt).body).window(12, 0, 24, 12));
}

TEST(Displays, AnAnaglyphsRedIsTheLeftEyesAndASubpixelOfItsView) {
  const std::string stereo = R"("look_at":[0,0,-5],"display":{"type":"stereo","separation":0.4)";
  const auto pair = pfm(size, stereo + "}");
  const auto anaglyph = pfm(size, stereo + R"(,"layout":"anaglyph"})");
  const auto woven = pfm(size, quilt + R"(,"interlace":{"pitch":2,"tilt":0.5})");
  const auto views = pfm(size, quilt);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) {
      EXPECT_EQ(anaglyph.at(x, y, 0), pair.at(x, y, 0));
      EXPECT_EQ(anaglyph.at(x, y, 1), pair.at(x + 12, y, 1));
      EXPECT_EQ(anaglyph.at(x, y, 2), pair.at(x + 12, y, 2));
      for (int c = 0; c < 3; ++c) {
        const double z = ((x + 0.5) / 12 + (c - 1) / 36.0 + (1 - (y + 0.5) / 12) * 0.5) * 2 + 1e-9;
        const int view = static_cast<int>((z - std::floor(z)) * 6);
        EXPECT_NEAR(woven.at(x, y, c), views.at(x + view % 3 * 12, y + (1 - view / 3) * 12, c),
                    2e-4);
      }
    }
}

TEST(Displays, FilesSayWhatTheyAreToOtherPrograms) {
  const Response of_quilt = drawn(size, quilt);
  EXPECT_EQ(header(of_quilt, "Content-Disposition"), "inline; filename=\"tia_qs3x2a1.png\"");
  EXPECT_EQ(text_in(of_quilt.body, "Tia quilt", 100), "qs3x2a1");
  const Response around =
      drawn(R"("width":24,"height":12,"crop":[3,2,20,9])", R"("projection":"equirectangular")");
  const std::string xmp = text_in(around.body, "XML:com.adobe.xmp", 2000).value_or("");
  for (const char* part : {"GPano:ProjectionType=\"equirectangular\"", "FullPanoWidthPixels=\"24\"",
                           "CroppedAreaImageWidthPixels=\"17\"", "CroppedAreaLeftPixels=\"3\"",
                           "CroppedAreaTopPixels=\"2\""})
    EXPECT_NE(xmp.find(part), xmp.npos) << part;
  EXPECT_NE(around.body.find("GPano:UsePanoramaViewer"), around.body.npos) << "not compressed";
  EXPECT_EQ(text_in(drawn(size, R"("projection":"fisheye")").body, "XML:com.adobe.xmp", 2000),
            std::nullopt);
}

TEST(Displays, ExplainTellsTheViewAndTheColourOfThePicture) {
  for (const auto& [camera, x, y, name, number] :
       {std::tuple{quilt, 17, 5, "view_4", 4}, {wall, 3, 14, "view_3", 3}}) {
    const std::string pixel = "\"x\":" + std::to_string(x) + ",\"y\":" + std::to_string(y) + ',';
    const Response told = host().post("/explain", "{" + pixel + size + "," + scene(camera) + "}");
    ASSERT_EQ(told.status, 200) << told.body;
    const Value explanation = parse_json(told.body);
    const Value& view = at(explanation, "view");
    EXPECT_EQ(at(view, "name"), Value(name));
    EXPECT_EQ(at(view, "number"), Value(number));
    EXPECT_EQ(at(view, "pixel"), (Value{Value::Array{x % 12, y % 12}}));
    const Value& color = at(at(explanation, "tree"), "color");
    const auto picture = pfm(size, camera);
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ((*color.as<Value::Array>())[static_cast<std::size_t>(c)],
                Value(picture.at(x, y, c)));
  }
}

TEST(Displays, ExplainTellsAllViewsThatShareAPixelAndTheirMixIsThePictures) {
  const std::string anaglyph =
      R"("look_at":[0,0,-5],"display":{"type":"stereo","separation":0.4,"layout":"anaglyph")";
  const auto numbers = [](const Value& triple) {
    std::array<double, 3> each{};
    for (std::size_t c = 0; c < 3; ++c) each[c] = *(*triple.as<Value::Array>())[c].as<double>();
    return each;
  };
  for (const std::string& camera : {anaglyph + "}", anaglyph + R"(,"matrix":"dubois"})",
                                    quilt + R"(,"interlace":{"pitch":2,"tilt":0.5})"}) {
    const auto picture = pfm(size, camera);
    const Response told =
        host().post("/explain", "{\"x\":7,\"y\":5," + size + "," + scene(camera) + "}");
    ASSERT_EQ(told.status, 200) << told.body;
    const Value first = parse_json(told.body);
    std::vector<const Value*> views{&first};
    for (const Value& other : *at(first, "others").as<Value::Array>()) views.push_back(&other);
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < views.size(); ++i) {
      EXPECT_EQ(at(at(*views[i], "view"), "number"), Value(static_cast<int>(i)));
      const auto color = numbers(at(at(*views[i], "tree"), "color"));
      for (std::size_t c = 0; c < 3; ++c) {
        const auto row = numbers((*at(*views[i], "mix").as<Value::Array>())[c]);
        for (std::size_t k = 0; k < 3; ++k) sum[c] += row[k] * color[k];
      }
    }
    EXPECT_EQ(views.size(), camera.starts_with(anaglyph) ? 2U : 3U);
    if (views.size() == 2)
      EXPECT_NE(at(at(first, "tree"), "ray"), at(at(*views[1], "tree"), "ray")) << "an eye's each";
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(sum[c], picture.at(7, 5, static_cast<int>(c)), 1e-6) << camera;
  }
}

TEST(Displays, WhatDoesNotFitIsRefused) {
  struct Case {
    std::string path, members, camera;
    const char *type, *pointer, *words;
  };
  const std::string fish = R"("projection":"fisheye")";
  const Case cases[] = {
      {"/render", R"("width":4000,"height":4000)", quilt, "limit", "/width", "TIA_MAX_PIXELS"},
      {"/render", R"("width":12,"height":8)", R"("display":{"type":"cube"})", "out-of-range",
       "/height", "squares"},
      {"/render", size + R"(,"crop":[0,0,37,24])", quilt, "out-of-range", "/crop", "x1 <= 36"},
      {"/render", size + R"(,"max_rays":100000,"integrator":"path")", quilt, "conflict",
       "/max_rays", "display"},
      {"/render", size + R"(,"crop":[0,0,3,3],"format":"zip")", quilt, "conflict", "/crop", "view"},
      {"/explain", size + R"(,"x":36,"y":3)", quilt, "out-of-range", "/x", "0 to 35"},
      {"/explain", size + R"(,"x":30,"y":20)", wall, "out-of-range", "/x", "5 views"},
      {"/explain", R"("width":20,"height":12,"x":0,"y":0)", fish, "out-of-range", "/x", "disc"},
  };
  for (const Case& each : cases) {
    const Response response =
        host().post(each.path, "{" + each.members + "," + scene(each.camera) + "}");
    SCOPED_TRACE(each.members + each.camera);
    EXPECT_EQ(response.status, 422);
    const Value problem = parse_json(response.body);
    EXPECT_EQ(at(problem, "type"), Value(std::string("/problems/") + each.type));
    const Value& error = (*at(problem, "errors").as<Value::Array>())[0];
    EXPECT_EQ(at(error, "pointer"), Value(each.pointer));
    EXPECT_NE(response.body.find(each.words), std::string::npos) << response.body;
  }
}

TEST(Displays, APatchThatNamesATypeReplacesTheDisplay) {
  const std::string body =
      "{" + size + R"(,"camera":{"display":{"type":"cube"}},)" + scene(quilt) + "}";
  const Response response = host().post("/render", body);
  EXPECT_EQ(response.status, 200) << response.body;
  EXPECT_EQ(primary_of(response), 6 * 144);
}

}  // namespace
}  // namespace tia::test
