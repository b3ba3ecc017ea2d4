// POST /models, GET and HEAD /models/{id}.
#include <httplib.h>
#include <sys/stat.h>

#include <fstream>

#include "server/stores/digest.h"
#include "tests/core/models/zip_files.h"
#include "tests/server/model_support.h"
#include "tests/server/process_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

Response post_file(Host& at_host, const std::string& body,
                   const std::string& type = "application/octet-stream",
                   const std::string& query = "") {
  return at_host.post("/models" + query, body, type);
}
std::string id_in(const Response& response) { return text_at(parse_json(response.body), "id"); }

std::string zip_of_files(const NamedTexts& texts, const std::string& folder = "") {
  std::vector<ZipItem> items;
  for (const auto& [path, text] : texts) items.push_back(zip_item(folder + path, text));
  return zip_of(items);
}

TEST(PostModels, TellsWhatIsInAFileWhoseIdIsItsSha256) {
  Host own;
  const std::string text = stl_text();
  const Response response = post_file(own, text);
  ASSERT_EQ(response.status, 201) << response.body;
  const Value told = parse_json(response.body);
  EXPECT_EQ(text_at(told, "id"), sha256_hex(text));
  EXPECT_EQ(header(response, "Location"), "/models/" + sha256_hex(text));
  EXPECT_EQ(number_at(told, "bytes"), static_cast<double>(text.size()));
  EXPECT_EQ(text_at(told, "format"), "stl");
  EXPECT_EQ(text_at(told, "up"), "z");
  EXPECT_EQ(number_at(told, "triangles"), 1);
  EXPECT_EQ(to_json(at(told, "bounds")), R"({"max":[1,1,0],"min":[0,0,0]})");
  EXPECT_EQ(to_json(at(told, "files")), R"([{"bytes":)" + std::to_string(text.size()) + "}]");
}

TEST(PostModels, TheSecondTimeIs200AndSaysTheSame) {
  Host own;
  const Response first = post_file(own, stl_text());
  const Response second = post_file(own, stl_text());
  EXPECT_EQ(first.status, 201);
  EXPECT_EQ(second.status, 200);
  EXPECT_EQ(second.body, first.body);
  EXPECT_EQ(header(second, "Location"), header(first, "Location"));
}

TEST(PostModels, TheBytesDecideWhateverTypeIsDeclared) {
  for (const char* type : {"application/x-www-form-urlencoded", "application/json", "image/png",
                           "model/gltf-binary", "multipart/form-data"})
    EXPECT_LT(post_file(host(), stl_text("typed"), type).status, 202) << type;
  EXPECT_EQ(host().ask("POST", "/models", stl_text("typed")).status, 200);
}

TEST(PostModels, AZipAFolderInAZipAndAFormOfTheSameFilesAreOneModel) {
  Host own;
  const Response form = post_file(own, form_of_files(obj_and_mtl()), form_type);
  ASSERT_EQ(form.status, 201) << form.body;
  EXPECT_EQ(id_in(form), upload_of_texts(obj_and_mtl()).id);
  const std::string zip = zip_of_files(obj_and_mtl());
  for (const Response& other :
       {post_file(own, zip, "application/zip"), post_file(own, zip_of_files(obj_and_mtl(), "a/b/")),
        post_file(own, form_of_files({{"chair.zip", zip}}), form_type)}) {
    EXPECT_EQ(other.status, 200);
    EXPECT_EQ(other.body, form.body);
  }
  const Value told = parse_json(form.body);
  EXPECT_EQ(text_at(at(told, "materials").as<Value::Array>()->at(0), "name"), "wood");
  EXPECT_EQ(text_at(at(told, "files").as<Value::Array>()->at(1), "path"), "mtl/wood.mtl");
}

TEST(PostModels, AFileThatCameAloneInAFormOrZipIsThatFile) {
  const std::string text = stl_text("alone");
  EXPECT_EQ(id_in(post_file(host(), form_of_files({{"a.stl", text}}), form_type)),
            sha256_hex(text));
  EXPECT_EQ(id_in(post_file(host(), zip_of_files({{"b/a.stl", text}}))), sha256_hex(text));
}

TEST(PostModels, MainSaysWhichOneWhereSeveralCouldBeMeant) {
  const std::string form = form_of_files({{"a.stl", stl_text("a")}, {"b.stl", stl_text("b")}});
  EXPECT_EQ(only_error(post_file(host(), form, form_type)).pointer, "/main");
  const Response a = post_file(host(), form, form_type, "?main=a.stl"),
                 b = post_file(host(), form, form_type, "?main=b.stl");
  EXPECT_EQ(a.status, 201) << a.body;
  EXPECT_NE(id_in(a), id_in(b));
  const Response none = post_file(host(), form, form_type, "?main=c.stl");
  EXPECT_EQ(none.status, 422);
  EXPECT_EQ(only_error(none).nearest.substr(1), ".stl");
  EXPECT_EQ(post_file(host(), form, form_type, "?mein=a.stl").status, 422);
}

TEST(PostModels, WhatIsNoModelIs415WithWhatIsTaken) {
  for (const std::string& body : {std::string(), std::string("nothing"), std::string("{}"),
                                  std::string("\x89PNG\r\n\x1A\n")}) {
    const Response response = post_file(host(), body);
    EXPECT_EQ(response.status, 415) << body;
    for (const char* format : {"GLB", "OBJ", "PLY", "STL", "ZIP"})
      EXPECT_THAT(problem_of(response).detail, HasSubstr(format));
  }
  EXPECT_EQ(post_file(host(), zip_of_files({{"a.txt", "nothing"}})).status, 415);
}

TEST(PostModels, OtherProgramsFormatsAre415ThatSayGlb) {
  const std::pair<const char*, std::string> rows[] = {
      {"FBX", "Kaydara FBX Binary  \x1a"},
      {"FBX", "; FBX 7.4.0 project file"},
      {"USD", "PXR-USDC"},
      {"USD", "#usda 1.0\n"},
      {"USD", zip_of_files({{"a.usdc", "PXR-USDC"}, {"b.png", "x"}})},
      {"3MF", zip_of_files({{"[Content_Types].xml", "<"}, {"3D/3dmodel.model", "<"}})}};
  for (const auto& [name, body] : rows) {
    const Response response = post_file(host(), body);
    EXPECT_EQ(response.status, 415) << name;
    EXPECT_THAT(problem_of(response).detail,
                testing::AllOf(HasSubstr(name), HasSubstr("export it as GLB")));
  }
}

TEST(PostModels, AllMissingFilesAreNamedAtOnce) {
  const Response response = post_file(host(), R"({"asset":{"version":"2.0"},"buffers":[
      {"uri":"a.bin","byteLength":36},{"uri":"b.bin","byteLength":36}]})");
  EXPECT_EQ(response.status, 422);
  const Problem problem = problem_of(response);
  ASSERT_EQ(problem.errors.size(), 2U) << response.body;
  EXPECT_EQ(problem.errors[0].got, Value("a.bin"));
  EXPECT_EQ(problem.errors[1].got, Value("b.bin"));
  EXPECT_THAT(problem.errors[1].pointer, HasSubstr("/buffers/1"));
}

TEST(PostModels, FaultsHaveTheirLine) {
  const Response response = post_file(host(), "v 0 0 0\nv 1 0 0\nv 0 1 x\nf 1 2 3\n");
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/unreadable");
  EXPECT_EQ(number_at(at(parse_json(response.body), "errors").as<Value::Array>()->at(0), "line"),
            3);
}

TEST(PostModels, WithoutATriangleOrAPointIs422) {
  const Response response = post_file(host(), R"({"asset":{"version":"2.0"}})");
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/missing");
}

TEST(PostModels, ABrokenArchiveOrFormIsRefused) {
  const std::string zip = zip_of_files(obj_and_mtl());
  EXPECT_EQ(post_file(host(), zip.substr(0, zip.size() - 1)).status, 422);
  EXPECT_EQ(post_file(host(), "--border\r\nnothing", form_type).status, 400);
}

TEST(GetModels, SaysWhatPostHasSaidAndHeadWhetherItIsThere) {
  Host own;
  const Response posted = post_file(own, stl_text());
  const std::string path = *header(posted, "Location");
  const Response got = own.get(path);
  EXPECT_EQ(got.status, 200);
  EXPECT_EQ(got.body, posted.body);
  EXPECT_EQ(own.head(path).status, 200);
  for (const std::string& none : {"/models/" + std::string(64, '0'), std::string("/models/parts"),
                                  std::string("/models/..%2fscenes.sqlite")}) {
    EXPECT_EQ(own.get(none).status, 404) << none;
    EXPECT_EQ(own.head(none).status, 404) << none;
  }
}

TEST(Models, AreCounted) {
  Host own;
  post_file(own, stl_text());
  post_file(own, stl_text());
  post_file(own, "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
  const auto series = series_of(own.get("/metrics").body);
  EXPECT_EQ(series.at("tia_models{state=\"kept\"}"), 1);
  EXPECT_EQ(series.at("tia_models{state=\"read\"}"), 1);
  EXPECT_EQ(series.at(R"(tia_model_reads_total{format="stl",result="read"})"), 1);
  EXPECT_EQ(series.at(R"(tia_model_reads_total{format="obj",result="refused"})"), 1);
  EXPECT_EQ(series.at("tia_model_read_seconds_count"), 2);
  EXPECT_EQ(series.at("tia_model_reader_deaths_total"), 0);
}

TEST(Models, AReaderThatDiesIs500AndOthersGoOn) {
  const Folder folder;
  const std::string program = folder.file("reader");
  std::ofstream(program) << "#!/bin/sh\nkill -SEGV $$\n";
  chmod(program.c_str(), 0700);
  Config config;
  config.threads = 2;
  const Gallery gallery;
  Backend backend(config, gallery, {}, program);
  const Request request{"POST", "/models", {}, stl_text(), Host::id};
  const Response response = answer(request, backend.service);
  EXPECT_EQ(response.status, 500);
  EXPECT_EQ(problem_of(response).type, "/problems/internal");
  EXPECT_THAT(response.failure, HasSubstr("signal 11"));
  EXPECT_EQ(answer({"GET", "/healthz", {}, "", Host::id}, backend.service).status, 200);
}

// ---- with a folder, over connections --------------------------------------------------------

TEST(ModelFiles, OutliveAServerThatIsKilledAndAreNeverGivenDamaged) {
  const Folder folder;
  const Process::Words arguments{"--port", "0", "--data-dir", folder.file("")};
  const std::string text = stl_text(), path = "/models/" + sha256_hex(text);
  std::string told;
  {
    Tia tia(arguments);
    const auto posted = tia.client().Post("/models", text, "model/stl");
    ASSERT_EQ(posted->status, 201) << posted->body;
    told = posted->body;
    tia.signal(SIGKILL);
    tia.wait();
  }
  {
    Tia tia(arguments);
    EXPECT_EQ(tia.get(path).body, told);
    EXPECT_EQ(tia.client().Post("/models", text, "model/stl")->status, 200);
  }
  std::ofstream(folder.file("models/" + sha256_hex(text)), std::ios::app) << "x";
  Tia tia(arguments);
  const Response damaged = tia.get(path);
  EXPECT_EQ(damaged.status, 503);
  EXPECT_EQ(problem_of(damaged).type, "/problems/storage");
}

}  // namespace
}  // namespace tia::test
