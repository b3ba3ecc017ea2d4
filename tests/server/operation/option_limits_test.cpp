// What the options bound, each met and passed by one: an option that is off by one fails here.
#include <httplib.h>

#include <functional>

#include "core/render/meter.h"
#include "core/scene/read_scene.h"
#include "server/operation/memory_account.h"
#include "server/stores/scene_bytes.h"
#include "tests/server/http/wire.h"
#include "tests/server/model_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

Config with(const std::function<void(Config&)>& set) {
  Config config;
  set(config);
  return config;
}

const std::string small_picture_target = "/render?width=8&height=6";

// ---- work and waiting -----------------------------------------------------------------------

// Whose service has no room for one more of those.
bool is_refused(const std::function<void()>& enter) {
  try {
    enter();
    return false;
  } catch (const HttpError& error) {
    EXPECT_EQ(error.type(), "busy");
    return true;
  }
}

TEST(OptionLimits, AsManyPicturesAreBegunAsRendersSays) {
  Host host(with([](Config& config) { config.renders = 3, config.queue = 0; }));
  Admission& admission = host.service().admission;
  std::vector<Admission::Ticket> tickets;
  for (int i = 0; i < 3; ++i)  // a client each, of whom none has more than half
    tickets.push_back(admission.enter({}, std::string(1, static_cast<char>('a' + i)), {}));
  EXPECT_TRUE(is_refused([&] { static_cast<void>(admission.enter({}, "d", {})); }));
}

TEST(OptionLimits, AsManyWaitAsQueueSays) {
  Host host(with([](Config& config) { config.renders = 1, config.queue = 2; }));
  Admission& admission = host.service().admission;
  const auto first = admission.wait_for_others(""), second = admission.wait_for_others("");
  EXPECT_TRUE(is_refused([&] { static_cast<void>(admission.wait_for_others("")); }));
}

TEST(OptionLimits, AsManyConnectionsAreOpenAsConnectionsSays) {
  Tia tia({"--port", "0", "--connections", "8"});
  const std::string get = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n";
  std::vector<std::unique_ptr<Wire>> wires;
  const auto another = [&] {
    wires.push_back(std::make_unique<Wire>(tia.port()));
    wires.back()->send(get);
    EXPECT_EQ(status_of(wires.back()->until("}")), 200);
  };
  for (int i = 0; i < 8; ++i) another();
  EXPECT_FALSE(wires[0]->readable());
  another();
  ASSERT_TRUE(wires[0]->readable(seconds(5)));  // and not when it has been idle for long
  EXPECT_EQ(wires[0]->rest(), "");
}

// ---- rays and tests -------------------------------------------------------------------------

// Threads tell them in portions: a small picture's are not told at all.
TEST(OptionLimits, APictureMayTakeMaxWorkTests) {
  Host host(with([](Config& config) { config.max_work = 1000; }));
  const Limits& limits = host.service().rendering.limits;
  RayMeter meter(limits.max_rays, limits.max_work, {});
  EXPECT_NO_THROW(meter.add_work(1000));
  EXPECT_THROW(meter.add_work(1), InputError);
}

// A body has 240 steps a second.
TEST(OptionLimits, AMotionMayHaveMaxEventsSteps) {
  const std::string scene = R"({"scene":{
    "objects":[{"name":"b","type":"sphere","center":[0,0,0],"radius":1}],
    "physics":{"solver":"rigid","duration":0.25,"bodies":[{"object":"b","mass":1}]}}})";
  const auto status = [&](std::int64_t most) {
    return Host(with([&](Config& config) { config.max_events = most; }))
        .post("/simulate", scene)
        .status;
  };
  EXPECT_EQ(status(60), 200);
  EXPECT_EQ(status(59), 422);
}

// ---- memory ---------------------------------------------------------------------------------

// 256 MiB less 64 for the program and an eighth.
TEST(OptionLimits, ARequestMayHaveMemoryBytesButForTheProgramAndAnEighth) {
  Host host(with([](Config& config) { config.memory_bytes = 268'435'456; }));
  EXPECT_NO_THROW(MemoryClaim(host.service().memory).reserve(167'772'160, "this", {}));
  EXPECT_THROW(MemoryClaim(host.service().memory).reserve(167'772'161, "this", {}), HttpError);
}

TEST(OptionLimits, ASceneIsKeptThatHasMaxScenesBytes) {
  const std::string text = R"({"title":")" + std::string(5000, 'x') + "\"}";
  Host plenty;
  plenty.kept().keep(read_scene(text));
  const auto bytes = static_cast<std::int64_t>(plenty.kept().bytes());
  const auto status = [&](std::int64_t most) {
    return Host(with([&](Config& config) { config.max_scenes_bytes = most; }))
        .post("/scenes", text)
        .status;
  };
  EXPECT_EQ(status(bytes), 201);
  EXPECT_EQ(status(bytes - 1), 422);
}

TEST(OptionLimits, ACompiledSceneIsKeptThatHasMaxGeometryBytes) {
  const auto kept = [](std::int64_t most) {
    Host host(with([&](Config& config) { config.max_geometry_bytes = most; }));
    EXPECT_EQ(host.get(small_picture_target).status, 200);
    return static_cast<std::int64_t>(host.geometries().counts().bytes);
  };
  const std::int64_t bytes = kept(1 << 20);
  EXPECT_GT(bytes, 0);
  EXPECT_EQ(kept(bytes), bytes);
  EXPECT_EQ(kept(bytes - 1), 0);
}

TEST(OptionLimits, APictureIsKeptThatHasCacheBytes) {
  const auto kept = [](std::int64_t most) {
    Host host(with([&](Config& config) { config.cache_bytes = most; }));
    EXPECT_EQ(host.get(small_picture_target).status, 200);
    return static_cast<std::int64_t>(host.service().pictures.counts().bytes);
  };
  const std::int64_t bytes = kept(1 << 20);
  EXPECT_GT(bytes, 0);
  EXPECT_EQ(kept(bytes), bytes);
  EXPECT_EQ(kept(bytes - 1), 0);
}

// ---- bodies ---------------------------------------------------------------------------------

TEST(OptionLimits, ABodyMayHaveMaxBodyBytesAndAPngMaxPngBytes) {
  Tia tia({"--port", "0", "--max-body-bytes", "2000", "--max-png-bytes", "3000"});
  const auto status = [&](std::string body, std::size_t size, const char* type) {
    body.resize(size, ' ');
    return tia.client().Post("/render", body, type)->status;
  };
  EXPECT_EQ(status(R"({"width":8,"height":6})", 2000, "application/json"), 200);
  EXPECT_EQ(status(R"({"width":8,"height":6})", 2001, "application/json"), 413);
  EXPECT_EQ(status("\x89PNG\r\n\x1A\n", 3000, "image/png"), 400);
  EXPECT_EQ(status("\x89PNG\r\n\x1A\n", 3001, "image/png"), 413);
}

// ---- models ---------------------------------------------------------------------------------

TEST(OptionLimits, AModelMayHaveMaxModelBytesHoweverFewOthersMayHave) {
  Tia tia({"--port", "0", "--max-body-bytes", "1024", "--max-model-bytes", "2000"});
  const auto status = [&](std::size_t size) {
    std::string body = stl_text();
    body.resize(size, ' ');
    return tia.client().Post("/models", body, "model/stl")->status;
  };
  EXPECT_EQ(status(2000), 201);
  EXPECT_EQ(status(2001), 413);
}

int status_of_model(const std::string& body, const std::function<void(Config&)>& set) {
  return Host(with(set)).post("/models", body, "application/octet-stream").status;
}

TEST(OptionLimits, AModelIsKeptThatHasMaxModelsBytes) {
  const std::string text = stl_text();
  const auto status = [&](std::size_t most) {
    return status_of_model(
        text, [&](Config& config) { config.max_models_bytes = static_cast<std::int64_t>(most); });
  };
  EXPECT_EQ(status(512 + text.size()), 201);
  EXPECT_EQ(status(512 + text.size() - 1), 422);
}

TEST(OptionLimits, AModelMayHaveMaxTriangles) {
  const auto status = [](int most) {
    return status_of_model("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 1 3\nf 1 3 2\n",
                           [&](Config& config) { config.max_triangles = most; });
  };
  EXPECT_EQ(status(3), 201);
  EXPECT_EQ(status(2), 422);
}

// Three pictures of a pixel each.
TEST(OptionLimits, AModelsTexturesMayHaveMaxTexturePixels) {
  const std::string picture =
      R"({"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAf)"
      R"(FcSJAAAADUlEQVR42mNk)"
      R"(+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="})";
  const std::string text =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"data:;base64,)"
      R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,)"
      R"("componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],)"
      R"("scenes":[{"nodes":[0]}],"scene":0,)"
      R"("textures":[{"source":0},{"source":1},{"source":2}],"images":[)" +
      picture + "," + picture + "," + picture + "]}";
  const auto status = [&](int most) {
    return status_of_model(text, [&](Config& config) { config.max_texture_pixels = most; });
  };
  EXPECT_EQ(status(3), 201);
  EXPECT_EQ(status(2), 422);
}

// The file alone is more than that.
TEST(OptionLimits, AModelsReaderHasModelMemoryBytes) {
  if (sanitized()) GTEST_SKIP() << "sanitizers need more than a confined process may";
  Host host(with([](Config& config) {
    config.model_memory_bytes = 64 << 20, config.max_model_bytes = 128 << 20;
    config.memory_bytes = 2LL << 30U;
  }));
  const Response response =
      host.post("/models", "solid " + std::string(70'000'000, ' '), "model/stl");
  EXPECT_EQ(response.status, 422);
  EXPECT_THAT(only_error(response).allowed, testing::HasSubstr("TIA_MODEL_MEMORY_BYTES"));
}

// The root, a list of numbers, and lists.
TEST(OptionLimits, ATextMayHaveMaxNodesValues) {
  const auto status = [](int lists) {
    Host host(with([](Config& config) { config.max_nodes = 5000; }));
    std::string text = R"({"width":8,"unknown":[1,2,3)";
    for (int i = 0; i < lists; ++i) text += ",[]";
    return problem_of(host.post("/render", text + "]}")).type;
  };
  EXPECT_EQ(status(5000 - 3), "/problems/unknown-name");
  EXPECT_EQ(status(5000 - 2), "/problems/limit");
}

}  // namespace
}  // namespace tia::test
