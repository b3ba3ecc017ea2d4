// Accept and Accept-Encoding: weights, and what is given or refused by them.
#include "server/requests/accept.h"

#include "server/contract/problem.h"
#include "server/requests/picture_request.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

Request accepting(const std::string& accept, const char* field = "Accept") {
  return {"GET", "/", {{field, accept}}, "", Host::id};
}

int weight(const std::string& accept, const char* type = "image/png") {
  return media_weight(accepting(accept), type);
}

TEST(MediaWeight, IsThatOfTheRangeThatNamesTheTypeMostClosely) {
  const std::string all = "*/*;q=0.1, image/*;q=0.2, image/png;q=0.3";
  EXPECT_EQ(weight(all), 300);
  EXPECT_EQ(weight(all, "image/x-portable-floatmap"), 200);
  EXPECT_EQ(weight(all, "application/json"), 100);
  EXPECT_EQ(weight("image/png;q=0, */*"), 0);
  EXPECT_EQ(weight("image/*", "imagery/png"), 0);
}

TEST(MediaWeight, IsOneUnlessSaidOtherwiseAndNoneForWhatIsNotNamed) {
  EXPECT_EQ(weight("image/png"), 1000);
  EXPECT_EQ(weight("text/html, image/png"), 1000);
  EXPECT_EQ(weight("text/html"), 0);
  for (const char* nothing : {"", " "}) EXPECT_EQ(weight(nothing), 1000);
  EXPECT_EQ(media_weight(Request{"GET", "/", {}, "", ""}, "image/png"), 1000);
}

TEST(MediaWeight, IsWrittenWithThreeDigitsAtMost) {
  const std::pair<const char*, int> weights[] = {
      {"0", 0},     {"1", 1000},  {"0.", 0},   {"1.000", 1000}, {"0.5", 500},
      {"0.05", 50}, {"0.001", 1}, {".2", 200}, {".5", 500},     {".", 0}};
  for (const auto& [text, thousandths] : weights)
    EXPECT_EQ(weight(std::string("image/png;q=") + text), thousandths) << text;
}

TEST(MediaWeight, ARangeWhoseWeightCannotBeReadIsLeftOut) {
  for (const char* text : {"", "2", "1.001", "0.0001", "-1", ".1234", "a", "1e0", "0.5x"})
    EXPECT_EQ(weight(std::string("image/png;q=") + text + ", */*;q=0.4"), 400) << text;
}

TEST(MediaWeight, CaseSpaceAndOtherParametersDoNotMatter) {
  for (const char* accept : {"IMAGE/PNG;Q=0.5", " image/png ; q=0.5 ", "image/png;level=1;q=0.5",
                             "text/html,,image/png\t;q=0.5,", "image/png;q=0.5;ext=\"a\""})
    EXPECT_EQ(weight(accept), 500) << accept;
}

TEST(MediaWeight, SeveralFieldsAreOneList) {
  const Request request{
      "GET", "/", {{"Accept", "text/html"}, {"accept", "image/png;q=0.5"}}, "", ""};
  EXPECT_EQ(media_weight(request, "text/html"), 1000);
  EXPECT_EQ(media_weight(request, "image/png"), 500);
}

// What java.net.URLConnection sends unless told otherwise.
TEST(MediaWeight, OfJavasOwnClientIsAFifth) {
  const char* const java = "text/html, image/gif, image/jpeg, *; q=.2, */*; q=.2";
  EXPECT_EQ(weight(java), 200);
  EXPECT_EQ(weight("*"), 1000);
  EXPECT_EQ(weight("*;q=0.3, image/png;q=0.1"), 100);
  EXPECT_EQ(host().get("/render?width=8&height=6", {{"Accept", java}}).status, 200);
}

bool takes_gzip(const std::string& accept) {
  return takes_coding(accepting(accept, "Accept-Encoding"), "gzip");
}

TEST(TakesCoding, WhereItIsNamedAndNotWorseThanNone) {
  for (const char* accept : {"gzip", "deflate, gzip, br", "GZIP;q=0.001", "*", "br, *;q=0.1",
                             "gzip;q=0.5, identity;q=0.5", "identity;q=0, gzip;q=0.1", "gzip;q=.2"})
    EXPECT_TRUE(takes_gzip(accept)) << accept;
  for (const char* accept : {"", "br", "gzip;q=0", "*;q=0", "gzip;q=0, *", "identity",
                             "gzip;q=0.5, identity", "gzipped", "gzip;q=x"})
    EXPECT_FALSE(takes_gzip(accept)) << accept;
  EXPECT_FALSE(takes_coding(Request{"GET", "/", {}, "", ""}, "gzip"));
}

// ---- the format of a picture ----------------------------------------------------------------

std::string format_for(const std::string& accept) {
  Value parameters = Value::Object{};
  EXPECT_TRUE(choose_format(parameters, accepting(accept), formats));
  return text_at(parameters, "format");
}

TEST(ChooseFormat, TakesTheOneOfGreatestWeightAndPngOfEquals) {
  for (const char* accept :
       {"", "*/*", "image/*", "image/png", "image/x-portable-floatmap, image/png",
        "text/html,application/xhtml+xml,application/xml;q=0.9,image/avif,image/webp,*/*;q=0.8",
        "image/avif,image/webp,image/apng,image/svg+xml,image/*,*/*;q=0.8"})
    EXPECT_EQ(format_for(accept), "png") << accept;
  for (const char* accept :
       {"image/x-portable-floatmap", "image/x-portable-floatmap, */*;q=0.9",
        "image/png;q=0.1, image/x-portable-floatmap;q=0.2", "image/*, image/png;q=0"})
    EXPECT_EQ(format_for(accept), "pfm") << accept;
  for (const char* accept : {"image/vnd.radiance", "image/vnd.radiance, */*;q=0.9",
                             "image/png;q=0.1, image/x-portable-floatmap;q=0.2, image/*;q=0.3"})
    EXPECT_EQ(format_for(accept), "hdr") << accept;
}

TEST(ChooseFormat, LeavesAFormatThatIsAskedForAsItIs) {
  const Value asked = Value::Object{{"format", "pfm"}};
  Value parameters = asked;
  EXPECT_FALSE(choose_format(parameters, accepting("image/png"), formats));
  EXPECT_FALSE(choose_format(parameters, accepting("text/html"), formats));
  EXPECT_EQ(parameters, asked);
}

TEST(ChooseFormat, LeavesWhatIsNoObjectToTheReader) {
  Value parameters = Value::Array{1};
  EXPECT_FALSE(choose_format(parameters, accepting("text/html"), formats));
}

TEST(ChooseFormat, RefusesWhoAcceptsNone) {
  for (const char* accept :
       {"text/html", "image/webp", "*/*;q=0", "image/*;q=0, text/html", "png"}) {
    Value parameters = Value::Object{};
    try {
      choose_format(parameters, accepting(accept), formats);
      ADD_FAILURE() << accept;
    } catch (const HttpError& error) {
      EXPECT_EQ(error.type(), "not-acceptable");
      EXPECT_THAT(
          error.detail(),
          HasSubstr(
              "image/png, image/x-portable-floatmap, image/vnd.radiance, image/tiff, image/x-exr"));
    }
  }
}

constexpr const char* pfm_type = "image/x-portable-floatmap";
constexpr const char* small_render = "/render?width=8&height=8";

TEST(AcceptOfRender, GivesThePictureThatTheFormatWouldForGetHeadAndPost) {
  for (const auto& [format, type] :
       {std::pair("pfm", pfm_type), {"hdr", "image/vnd.radiance"}, {"exr", "image/x-exr"}}) {
    const Headers headers{{"Accept", type}};
    const std::string bytes = host().get(std::string(small_render) + "&format=" + format).body;
    const Response get = host().get(small_render, headers);
    const Response post = host().ask("POST", "/render", R"({"width":8,"height":8})", headers);
    EXPECT_EQ(get.content_type, type);
    EXPECT_TRUE(get.body == bytes);
    EXPECT_TRUE(post.body == bytes);
    EXPECT_EQ(host().ask("HEAD", small_render, "", headers).content_type, type);
  }
  for (const char* accept : {"", "*/*", "image/png"})
    EXPECT_EQ(host().get(small_render, {{"Accept", accept}}).content_type, "image/png") << accept;
}

TEST(AcceptOfRender, VariesTheAnswerOnlyWhereNoFormatIsAskedFor) {
  EXPECT_EQ(header(host().get(small_render), "Vary"), "Accept");
  EXPECT_EQ(header(host().head(small_render), "Vary"), "Accept");
  const std::string asked = std::string(small_render) + "&format=png";
  EXPECT_FALSE(header(host().get(asked), "Vary"));
  EXPECT_EQ(host().get(asked, {{"Accept", pfm_type}}).content_type, "image/png");
}

TEST(AcceptOfRender, ThatAllowsNoPictureIs406SayingWhatThereIs) {
  for (const char* method : {"GET", "POST"}) {
    const Response response = host().ask(method, "/render", "{}", {{"Accept", "image/webp"}});
    EXPECT_EQ(response.status, 406);
    const Problem problem = problem_of(response);
    EXPECT_EQ(problem.type, "/problems/not-acceptable");
    EXPECT_THAT(
        problem.detail,
        HasSubstr(
            "image/png, image/x-portable-floatmap, image/vnd.radiance, image/tiff, image/x-exr"));
  }
}

// ---- what is JSON only ----------------------------------------------------------------------

constexpr const char* json_targets[] = {"/scenes", "/scenes/thesis", "/schema/scene.json",
                                        "/explain?x=1&y=1"};

TEST(Json, IsRefusedToWhoAcceptsNoneSayingWhatThereIs) {
  for (const char* target : json_targets)
    for (const char* accept : {"text/html", "image/*", "application/json;q=0", "*/*;q=0"}) {
      SCOPED_TRACE(std::string(target) + " " + accept);
      const Response response = host().get(target, {{"Accept", accept}});
      EXPECT_EQ(response.status, 406);
      const Problem problem = problem_of(response);  // which is sent whatever is accepted
      EXPECT_EQ(problem.type, "/problems/not-acceptable");
      EXPECT_THAT(problem.detail, HasSubstr("application/"));
    }
}

TEST(Json, IsGivenToAllOthers) {
  for (const char* target : json_targets)
    for (const char* accept : {"", "*/*", "application/*", "application/json",
                               "text/html, */*;q=0.1", "application/json; charset=utf-8"})
      EXPECT_EQ(host().get(target, {{"Accept", accept}}).status, 200) << target << " " << accept;
  EXPECT_EQ(host().get("/schema/scene.json", {{"Accept", "application/schema+json"}}).status, 200);
}

TEST(Json, NothingIsKeptOrExplainedForWhoWouldNotTakeTheAnswer) {
  const Headers headers{{"Accept", "image/png"}, {"Content-Type", "application/json"}};
  EXPECT_EQ(host().ask("POST", "/explain", R"({"x":1,"y":1})", headers).status, 406);
  const std::string id = text_at(parse_json(host().post("/scenes", "{}").body), "id");
  Host other;
  EXPECT_EQ(other.ask("POST", "/scenes", "{}", headers).status, 406);
  EXPECT_EQ(other.get("/scenes/" + id).status, 404);
}

TEST(Accept, IsNotAskedOfProbesAndThePage) {
  for (const char* target : {"/", "/style.css", "/healthz", "/version"})
    EXPECT_EQ(host().get(target, {{"Accept", "x/y"}}).status, 200) << target;
}

}  // namespace
}  // namespace tia::test
