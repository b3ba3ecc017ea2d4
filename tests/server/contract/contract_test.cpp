// The judge of all answers, fed with wrong ones: it must find each.
#include "tests/server/contract/contract.h"

#include <gtest/gtest-spi.h>

#include "tests/server/support.h"
#include "tests/server/witness.h"

namespace tia::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

// A small document: of /thing one answer in JSON, of /things/{name} none but problems.
const Contract& small() {
  static const Contract contract(parse_json(R"({
    "paths": {
      "/thing": {"get": {
        "parameters": [{"name": "size", "in": "query", "schema": {"type": "integer"}}],
        "responses": {
          "200": {
            "headers": {"Tag": {"$ref": "#/components/headers/Tag"},
                        "Hint": {"required": false, "schema": {"pattern": "^h"}}},
            "content": {"application/json": {"schema": {"$ref": "#/components/schemas/thing"}},
                        "image/png": {"x-required-headers": ["Hint"]}}},
          "304": {"headers": {"Tag": {"$ref": "#/components/headers/Tag"}}},
          "default": {"$ref": "#/components/responses/default"}}}},
      "/things/{name}": {"post": {
        "parameters": [{"name": "name", "in": "path", "schema": {"enum": ["a", "b"]}}],
        "requestBody": {"content": {"application/json": {"schema": {"$ref": "#/components/schemas/thing"}}}},
        "responses": {"201": {}, "default": {"$ref": "#/components/responses/default"}}}}},
    "components": {
      "headers": {"Tag": {"required": true, "schema": {"pattern": "^t[0-9]$"}}},
      "responses": {
        "404": {"content": {"application/problem+json": {"schema": {"$ref": "#/components/schemas/problem"}}}},
        "422": {"content": {"application/problem+json": {"schema": {"$ref": "#/components/schemas/problem"}}}},
        "options": {"headers": {"Tag": {"$ref": "#/components/headers/Tag"}}},
        "default": {"content": {"application/problem+json": {"schema": {
          "$ref": "#/components/schemas/problem", "properties": {"status": {"enum": [400]}}}}}}},
      "schemas": {
        "thing": {"type": "object", "additionalProperties": false, "required": ["parts"],
                  "properties": {"parts": {"type": "array", "items": {"$ref": "#/components/schemas/part"}}}},
        "part": {"type": "object", "additionalProperties": {"type": "number"}},
        "problem": {"type": "object", "required": ["status"], "properties": {"status": {"type": "integer"}}}}}})"));
  return contract;
}

Request asking(const std::string& target) { return {"GET", target, {}, "", ""}; }

Response thing_answer(const std::string& body) {
  return {
      .status = 200, .content_type = "application/json", .body = body, .headers = {{"Tag", "t1"}}};
}
Response problem_answer(int status, const std::string& body) {
  return {.status = status, .content_type = "application/problem+json", .body = body};
}
Response with_headers(Response response, Headers headers) {
  response.headers = std::move(headers);
  return response;
}

TEST(Contract, AllowsWhatTheDocumentDoes) {
  const Response good = thing_answer(R"({"parts":[{"x":1}]})");
  EXPECT_THAT(small().faults(asking("/thing?size=3&"), good), IsEmpty());
  EXPECT_THAT(small().faults(asking("/thing"), with_headers(good, {{"Tag", "t9"}, {"Hint", "h"}})),
              IsEmpty());
  EXPECT_THAT(small().faults(asking("/thing"), with_headers(good, {{"Tag", "t1"}, {"Date", "x"}})),
              IsEmpty());
  Response picture = thing_answer("\x89PNG");
  picture.content_type = "image/png";
  picture.headers.emplace_back("Hint", "h");
  EXPECT_THAT(small().faults(asking("/thing"), picture), IsEmpty());
  EXPECT_THAT(small().faults(asking("/thing"), problem_answer(400, R"({"status":400})")),
              IsEmpty());
  EXPECT_THAT(small().faults(asking("/things/c"), problem_answer(404, R"({"status":404})")),
              IsEmpty());
  const Response nothing{.status = 201, .content_type = "", .body = ""};
  EXPECT_THAT(small().faults({"POST", "/things/a", {}, R"({"parts":[]})", ""}, nothing), IsEmpty());
  const Response head = with_headers(thing_answer(""), {});
  EXPECT_THAT(small().faults({"HEAD", "/thing", {}, "", ""}, head), IsEmpty());
}

/// Wrong: an answer that must be found out, and the words for it.
struct Wrong {
  const char* law;
  Request request;
  Response response;
  const char* fault;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.law; }

class Contradiction : public testing::TestWithParam<Wrong> {};

TEST_P(Contradiction, IsFoundWithOperationAndPlace) {
  EXPECT_THAT(small().faults(GetParam().request, GetParam().response),
              Contains(HasSubstr(GetParam().fault)));
}

const std::string right_body = R"({"parts":[]})";
const Response created{.status = 201, .content_type = "", .body = ""};

INSTANTIATE_TEST_SUITE_P(
    By, Contradiction,
    testing::Values(
        Wrong{"AStatus", asking("/thing"), problem_answer(404, R"({"status":404})"),
              "GET /thing -> 404: body at \"/status\""},
        Wrong{"AContentType", asking("/thing"),
              [] {
                Response response = thing_answer(right_body);
                response.content_type = "application/json; charset=utf-8";
                return response;
              }(),
              "GET /thing -> 200: content type \"application/json; charset=utf-8\""},
        Wrong{"ABodyWhereThereIsNone", asking("/thing"),
              [] {
                Response response = thing_answer(right_body);
                response.status = 304;
                return response;
              }(),
              "GET /thing -> 304: a body, application/json"},
        Wrong{"ANameMore", asking("/thing"), thing_answer(R"({"parts":[],"x":1})"),
              "body at \"/x\""},
        Wrong{"ANameLess", asking("/thing"), thing_answer("{}"), "GET /thing -> 200: body at \"\""},
        Wrong{"ATypeFarInside", asking("/thing?a"),
              thing_answer(R"({"parts":[{},{"x":1,"y":"2"}]})"), "body at \"/parts/1/y\""},
        Wrong{"NoJson", asking("/thing"), thing_answer("{"), "body is no JSON"},
        Wrong{"AMissingHeader", asking("/thing"),
              with_headers(thing_answer(right_body), {{"Hint", "h"}}),
              "GET /thing -> 200: no header Tag"},
        Wrong{"AMissingHeaderOfAType", asking("/thing"),
              [] {
                Response response = thing_answer(right_body);
                response.content_type = "image/png";
                return response;
              }(),
              "GET /thing -> 200: no header Hint"},
        Wrong{"AHeaderOfAnotherForm", asking("/thing"),
              with_headers(thing_answer(right_body), {{"Tag", "t12"}}), "header Tag: t12"},
        Wrong{"AHeaderThatIsNotDescribed", asking("/thing"),
              with_headers(thing_answer(right_body), {{"Tag", "t1"}, {"Etag", "\"x\""}}),
              "header Etag is not described"},
        Wrong{"AStatusThatIsNotTheDocuments", asking("/thing"),
              problem_answer(422, R"({"status":400})"), "body at \"/status\": 400"},
        Wrong{"AnAnswerToNoOperation", asking("/nothing"), thing_answer(right_body),
              "GET /nothing -> 200: "},
        Wrong{"AFaultOfInputToNoOperation", asking("/nothing"),
              problem_answer(422, R"({"status":422})"), "GET /nothing -> 422: no such answer"},
        Wrong{"ANameThatTheTemplateDoesNotKnow", Request{"POST", "/things/c", {}, right_body, ""},
              created, "POST /things/c -> 201: "},
        Wrong{"AnotherMethod", Request{"PUT", "/thing", {}, "", ""}, thing_answer(right_body),
              "PUT /thing -> 200"},
        Wrong{"AParameterThatShouldHaveBeenRefused", asking("/thing?width=1"),
              thing_answer(right_body), "GET /thing -> 200: parameter width was taken"},
        Wrong{"ABodyThatShouldHaveBeenRefused",
              Request{"POST", "/things/a", {}, R"({"parts":1})", ""}, created,
              "POST /things/{name} -> 201: the request's body, which was taken, at \"/parts\""}),
    law_of);

// ---- hooked in
// ------------------------------------------------------------------------------------

Response healthy() { return host().get("/healthz"); }

TEST(Contract, FailsTheTestThatGetsAWrongAnswer) {
  Response response = healthy();
  response.body = R"({"status":"fine"})";
  EXPECT_NONFATAL_FAILURE(expect_allowed(asking("/healthz"), response),
                          "GET /healthz -> 200: body at \"/status\"");
}

TEST(Witness, FailsTheTestWhoseConnectionGetsAWrongAnswer) {
  constexpr int port = 1;  // nobody's: no connection is made
  const ServicePort served(port);
  Witness witness(port);
  witness.sent("GET /healthz HTTP/1.1\r\nHost: x\r\n\r\nHEAD /versi");
  witness.sent("on HTTP/1.1\r\nHost: x\r\n\r\n");
  witness.received("HTTP/1.1 200 OK\r\nX-Request-Id: a\r\nCache-Control: no-store\r\n");
  EXPECT_NONFATAL_FAILURE(
      witness.received("Content-Type: application/json\r\nContent-Length: 2\r\n\r\n{}"),
      "GET /healthz -> 200: body");
  EXPECT_NONFATAL_FAILURE(witness.received("HTTP/1.1 200 OK\r\nContent-Type: text/plain\r\n"
                                           "Content-Length: 100\r\n\r\n"),
                          "HEAD /version -> 200: content type \"text/plain\"");
}

TEST(Witness, OfAPortThatIsNotTheServicesJudgesNothing) {
  Witness witness(1);
  witness.sent("GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n");
  witness.received("HTTP/1.1 299 What\r\n\r\n");
}

TEST(Witness, TakesARefusalOfWhatIsNoRequest) {
  const ServicePort served(1);
  Witness witness(1);
  witness.sent("GET\r\n\r\n");
  EXPECT_NONFATAL_FAILURE(witness.received("HTTP/1.1 422 Unprocessable\r\n\r\n"),
                          "422: no such answer");
}

}  // namespace
}  // namespace tia::test
