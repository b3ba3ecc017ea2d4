// Maps of radio waves over HTTP.
#include <cstring>

#include "tests/server/handlers/streams_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string house = R"({"objects":[
  {"name":"street","type":"plane","point":[0,0,0],"normal":[0,1,0],
   "material":{"radio":{"type":"conductor"}}},
  {"name":"house","type":"box","min":[2,0,2],"max":[6,9,5]}]})";
const std::string asked =
    R"("frequency_hz":2.4e9,"rays":2000,"area":[-2,-1,7,6],"cell":1,"height":2)";
std::string map_body(const std::string& more, const std::string& scene = house) {
  return R"({"scene":)" + scene + "," + asked + more + "}";
}
const std::string one = R"(,"tx":[[0,4,0]])";
std::string header_of(const Response& response, std::string_view name) {
  return header(response, name).value_or("");
}
std::string map_query(const std::string& more, const std::string& cell = "1") {
  return "/radio/map?scene=" + url_encode(house) +
         "&frequency_hz=2.4e9&rays=2000&area=-2,-1,7,6&height=2&cell=" + cell + more;
}

TEST(RadioMapRoute, EachCellIsWhatPathsTellsAtItsCenterAndExplainToo) {
  const Response told = host().post("/radio/map", map_body(one + R"(,"format":"json")"));
  ASSERT_EQ(told.status, 200) << told.body;
  const Value map = parse_json(told.body);
  EXPECT_EQ(number_at(map, "width"), 9);
  EXPECT_EQ(number_at(map, "height"), 7);
  EXPECT_EQ(number_at(map, "y"), 2);
  EXPECT_EQ(text_at(map, "unit"), "dB");
  const auto& rows = *at(map, "values").as<Value::Array>();
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(rows[3].as<Value::Array>()->at(5), Value());  // in the house
  const Response paths =
      host().post("/radio/paths", R"({"scene":)" + house + R"(,"frequency_hz":2.4e9,
      "rays":2000,"transmitters":[{"position":[0,4,0]}],"receivers":[{"position":[6.5,2,0.5]}]})");
  ASSERT_EQ(paths.status, 200) << paths.body;
  const Value pair = at(parse_json(paths.body), "pairs").as<Value::Array>()->at(0);
  EXPECT_EQ(rows[1].as<Value::Array>()->at(8), at(at(pair, "total"), "incoherent_db"));
  const Response cell = host().post(
      "/explain", R"({"x":8,"y":1,"scene":)" + house + R"(,"radio":{)" + asked + one + "}}");
  EXPECT_EQ(cell.status, 200) << cell.body;
  EXPECT_TRUE(cell.body == paths.body);
}

TEST(RadioMapRoute, AnAddressIsAMap) {
  const Response png = host().get(map_query("&tx=0,4,0"));
  ASSERT_EQ(png.status, 200) << png.body;
  EXPECT_EQ(png.content_type, "image/png");
  EXPECT_TRUE(png.body == host().post("/radio/map", map_body(one)).body);
  const std::string etag = header_of(png, "ETag");
  const Response head = host().head(map_query("&tx=0,4,0&quantity=gain&scale=4"));
  EXPECT_EQ(header_of(head, "ETag"), etag);
  EXPECT_NE(header_of(host().head(map_query("&tx=0,4,0.5")), "ETag"), etag);
  EXPECT_THAT(header_of(host().get(map_query("&tx=0,4,0")), "Cache-Status"), HasSubstr("hit"));
}

// Maps of cells of eight and four times the side, in as large pixels, then the map itself. Whoever
// is slow sees the last ones.
TEST(RadioMapRoute, IsShownInLargerCellsWhileItIsDrawn) {
  Server server;
  int seen = 0;
  std::string target;
  for (int i = 0; i < 50 && seen < 2; ++i) {
    const std::string tx = "&tx=0,4," + std::to_string(0.1 + 0.01 * i);
    target = map_query(tx + "&scale=2");
    const auto events = events_in(ask_on(server.port(), target + "&stream=events").body);
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.back().name, "done");
    EXPECT_TRUE(ask_on(server.port(), text_at(events.back().data, "href")).body ==
                plain_bytes(target));
    for (std::size_t k = 0; k + 1 < events.size(); ++k, ++seen) {
      EXPECT_EQ(events[k].name, "round");
      EXPECT_EQ(at(events[k].data, "preview"), Value(true));
      const std::string coarse = number_at(events[k].data, "round") == 0
                                     ? map_query(tx + "&scale=16", "8")
                                     : map_query(tx + "&scale=8", "4");
      EXPECT_TRUE(ask_on(server.port(), text_at(events[k].data, "href")).body ==
                  plain_bytes(coarse));
    }
  }
  EXPECT_GE(seen, 2);
  const auto pictures = pictures_in(ask_on(server.port(), target + "&stream=multipart"));
  ASSERT_FALSE(pictures.empty());
  EXPECT_TRUE(pictures.back() == plain_bytes(target));
}

TEST(RadioMapRoute, StreamsOnlyWhatIsDrawnAsAPicture) {
  const std::string target = map_query("&tx=0,4,0&stream=events");
  EXPECT_EQ(only_error(host().get(target + "&format=pfm")).pointer, "/stream");
  EXPECT_EQ(host().head(target).status, 422);
  EXPECT_EQ(only_error(host().get(map_query("&tx=0,4,0&stream=mjpeg"))).pointer, "/stream");
}

TEST(RadioMapRoute, TellsSeveralTransmittersEachOnce) {
  const auto best = [](const std::string& more) {
    const Response told = host().get(map_query("&quantity=best_server&format=json" + more));
    EXPECT_EQ(told.status, 200) << told.body;
    return at(parse_json(told.body), "values");
  };
  const Value two = best("&tx=-1.5,3,0&tx=6.5,3,0");
  EXPECT_EQ(two, best("&tx=[[-1.5,3,0],[6.5,3,0]]"));
  EXPECT_EQ(two, best("&transmitters=" +
                      url_encode(R"([{"position":[-1.5,3,0]},{"position":[6.5,3,0]}])")));
  const auto& row = *two.as<Value::Array>()->at(0).as<Value::Array>();
  EXPECT_EQ(row.front(), Value(0));
  EXPECT_EQ(row.back(), Value(1));
}

TEST(RadioMapRoute, FloatsAreTheNumbersFromTheLastRowOn) {
  const Response pfm = host().post("/radio/map", map_body(one + R"(,"format":"pfm")"));
  const Value map =
      parse_json(host().post("/radio/map", map_body(one + R"(,"format":"json")")).body);
  const std::string head = "Pf\n9 7\n-1.0\n";
  ASSERT_EQ(pfm.body.size(), head.size() + std::size_t{9 * 7 * 4});
  EXPECT_TRUE(pfm.body.starts_with(head));
  const auto& rows = *at(map, "values").as<Value::Array>();
  for (std::size_t i = 0; i < 63; ++i) {
    float is = 0;
    std::memcpy(&is, pfm.body.data() + head.size() + 4 * i, 4);
    const Value& value = rows[6 - i / 9].as<Value::Array>()->at(i % 9);
    if (const double* number = value.as<double>()) EXPECT_EQ(is, static_cast<float>(*number));
    else EXPECT_TRUE(std::isnan(is));
  }
}

TEST(RadioMapRoute, SaysWhatIsWrongAtItsPlace) {
  const auto pointer = [](const std::string& more, const std::string& scene = house) {
    return only_error(host().post("/radio/map", map_body(more, scene))).pointer;
  };
  EXPECT_EQ(pointer(""), "/tx");
  EXPECT_EQ(pointer(one + R"(,"transmitters":[{"position":[0,4,0]}])"), "/tx");
  EXPECT_EQ(pointer(R"(,"tx":[[0,4,0],[3,1,3]])"), "/tx/1");
  EXPECT_EQ(pointer(R"(,"transmitters":[{"position":[3,1,3]}])"), "/transmitters/0/position");
  EXPECT_EQ(pointer(one + R"(,"max_reflections":11)"), "/max_reflections");
  EXPECT_EQ(pointer(one + R"(,"range":[3,3])"), "/range");
  EXPECT_EQ(pointer(one + R"(,"version":"0.0.1")"), "/version");
  EXPECT_EQ(pointer(one + R"(,"quantity":"gian")"), "/quantity");
  EXPECT_EQ(pointer(one, "\"flot\""), "/scene");
  EXPECT_EQ(pointer(one + R"(,"method":"image")", "\"thesis\""), "/method");
  const std::string bare = R"({"scene":{},"frequency_hz":1e9,"tx":[[0,1,0]])";
  const auto of = [](const std::string& body) {
    return only_error(host().post("/radio/map", body)).pointer;
  };
  EXPECT_EQ(of(bare + "}"), "/area");
  EXPECT_EQ(of(bare + R"(,"area":[3,0,1,1]})"), "/area");
  EXPECT_EQ(of(bare + R"(,"area":[0,0,9,9],"cell":1e-6})"), "/cell");
  EXPECT_EQ(of(bare + R"(,"origin":[0,0,0],"u":[1,0,0]})"), "/v");
  EXPECT_EQ(of(bare + R"(,"origin":[0,0,0],"u":[1,0,0],"v":[1,1,0]})"), "/v");
  const std::string thesis = "/radio/map?scene=thesis&frequency_hz=1e9";
  EXPECT_EQ(only_error(host().get(thesis + "&tx=1,2")).pointer, "/tx/0");
  EXPECT_EQ(only_error(host().get(thesis + "&tx=1,2,3&tx=a")).pointer, "/tx/1");
  EXPECT_EQ(only_error(host().get(thesis + "&tx=a&tx=1,2,3")).pointer, "/tx");
}

}  // namespace
}  // namespace tia::test
