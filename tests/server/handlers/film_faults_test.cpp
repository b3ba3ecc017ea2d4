// What /film refuses before its first frame, naming parameter, pointer and time.
#include <fstream>

#include "tests/server/handlers/film_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

struct FilmFault {
  const char* law;
  std::string parameters;
  const char* type;
  const char* pointer;
  const char* allowed;
  std::string scene = moving_lamp;
};
void PrintTo(const FilmFault& fault, std::ostream* out) { *out << fault.law; }
class FilmFaultOf : public testing::TestWithParam<FilmFault> {};

TEST_P(FilmFaultOf, IsNamed) {
  const FilmFault& fault = GetParam();
  const Response response = host().post("/film", film_body(fault.parameters, fault.scene));
  EXPECT_EQ(response.status, 422) << response.body;
  EXPECT_EQ(problem_of(response).type, std::string("/problems/") + fault.type);
  const ProblemError error = only_error(response);
  EXPECT_EQ(error.pointer, fault.pointer);
  EXPECT_THAT(error.allowed, HasSubstr(fault.allowed));
}

const std::string growing = R"({"animation":{"duration":2,"fps":4,"tracks":[
    {"target":"/objects/0/radius","formula":"1-t"}]},
  "objects":[{"type":"sphere","center":[0,0,-9],"radius":1}]})";

const FilmFault film_faults[] = {
    {"UnknownFormat", R"("format":"gif",)", "unknown-name", "/format", "apng, webp, webm, zip"},
    {"AVideoOfWhatIsTransparent", R"("format":"webm",)", "conflict", "/format", "apng, webp, zip",
     R"({"backdrop":"transparent","objects":[]})"},
    {"AWebpThatIsTooWide", R"("format":"webp","width":16384,"height":1,)", "conflict", "/format",
     "at most 16383 pixels"},
    {"AnMp4WithoutFfmpeg", R"("format":"mp4",)", "conflict", "/format", "TIA_FFMPEG"},
    {"AMjpegOfWhatIsTransparent", R"("format":"mjpeg",)", "conflict", "/format", "apng, webp, zip",
     R"({"backdrop":"transparent","objects":[]})"},
    {"ATime", R"("time":1,)", "unknown-name", "/time", "from, to, fps"},
    {"FromBeyondTheEnd", R"("from":1.5,)", "out-of-range", "/from", "from 0 to 1 (s)"},
    {"ToBeyondTheEnd", R"("to":1.5,)", "out-of-range", "/to", "from 0 to 1 (s)"},
    {"ToBeforeFrom", R"("from":0.5,"to":0.25,)", "conflict", "/to", "after from"},
    {"NoFrameBetween", R"("from":0.26,"to":0.3,)", "out-of-range", "/from", "0.125 s apart"},
    {"FpsOfZero", R"("fps":0,)", "out-of-range", "/fps", "from 0.001 to 1000"},
    {"FramesOfTheAnimationThatLastForDays", "", "out-of-range", "/fps", "at most 1000 s",
     R"({"animation":{"duration":1,"fps":1e-6,"tracks":[]},"objects":[]})"},
    {"MoreFramesThanMaxFrames", R"("fps":1000,)", "limit", "/fps", "TIA_MAX_FRAMES",
     R"({"animation":{"duration":3.601,"tracks":[]},"objects":[]})"},
    {"FromOfASceneThatDoesNotMove", R"("from":0,)", "conflict", "/from", "does not move",
     R"({"objects":[]})"},
    {"AValueThatIsNoneAtATime", "", "out-of-range", "/scene/animation/tracks/0", "at 1 s", growing},
};
INSTANTIATE_TEST_SUITE_P(All, FilmFaultOf, testing::ValuesIn(film_faults), law_of);

TEST(FilmLimits, FramesAreAsManyAsMaxFramesSays) {
  Config config;
  config.max_frames = 8;
  Host few(config);
  EXPECT_EQ(few.ask("HEAD", "/film?scene=lamp-round&width=8&height=6&fps=1").status, 200);
  const Response refused = few.ask("HEAD", "/film?scene=lamp-round&width=8&height=6&fps=1.01");
  EXPECT_EQ(refused.status, 422);
}

// Of the whole film, before its first frame.
TEST(FilmLimits, RaysThatAreSureToComeAreAPicturesTogether) {
  Config config;
  config.max_rays = 8 * 6 * 10;
  Host few(config);
  const std::string target = "/film?scene=lamp-round&width=8&height=6&fps=10&to=";
  EXPECT_EQ(few.ask("HEAD", target + "1").status, 200);
  const ProblemError error = only_error(few.get(target + "1.1"));
  EXPECT_EQ(error.pointer, "/samples");
  EXPECT_THAT(error.allowed, HasSubstr("TIA_MAX_RAYS"));
}

// Else it would be found out after its first frame.
TEST(FilmLimits, MemoryForAnEncoderIsAskedForBeforeTheFirstRay) {
  Tia small({"--port", "0", "--memory-bytes", std::to_string(256 << 20)});
  const std::string target = "/film?scene=lamp-round&format=webm&fps=1&to=1&width=";
  const Response refused = ask_on(small.port(), target + "2048&height=1024");
  EXPECT_EQ(refused.status, 413);
  EXPECT_THAT(refused.body, HasSubstr("TIA_MEMORY_BYTES"));
  const auto metrics = series_of(ask_on(small.port(), "/metrics").body);
  EXPECT_EQ(metrics.at("tia_rays_total{kind=\"primary\"}"), 0);
  EXPECT_EQ(ask_on(small.port(), target + "64&height=48").status, 200);
}

// ---- clients ------------------------------------------------------------------------------------

const std::string long_film = "/film?scene=lamp-round&width=640&height=480&fps=100&samples=8";

bool is_at_rest(Server& server) {
  const Service& service = server.host().service();
  return service.admission.at_work() + service.admission.waiting() == 0 &&
         service.memory.held(MemoryAccount::requests) == 0;
}

TEST(FilmInTime, ThatNobodyReadsAnyMoreEndsWithin100Ms) {
  double nearest = 1e9;
  for (int i = 0; i < 5 && nearest > 100; ++i) {
    Server server;
    Wire wire(server.port());
    wire.get(long_film);
    wire.until("\r\n\r\n");
    EXPECT_EQ(at_work(server), 1);
    const auto left = Clock::now();
    wire.leave();
    while (at_work(server) > 0 && ms_since(left) < 20'000)
      std::this_thread::sleep_for(milliseconds(1));
    nearest = std::min(nearest, ms_since(left));
    EXPECT_TRUE(eventually([&] { return is_at_rest(server); }));
  }
  EXPECT_LT(nearest, 100);
}

TEST(FilmClients, SixtyFourThatDoNotReadKeepNobodyFromHealthAndLeaveNothing) {
  Server server;
  std::vector<std::unique_ptr<Wire>> all;
  for (int i = 0; i < 64; ++i) {
    all.push_back(std::make_unique<Wire>(server.port(), 4096));
    all.back()->get(long_film + "&seed=" + std::to_string(i));
  }
  EXPECT_TRUE(eventually([&] { return at_work(server) > 0; }));
  for (int i = 0; i < 5; ++i) EXPECT_EQ(ask_on(server.port(), "/healthz").status, 200);
  all.clear();
  EXPECT_TRUE(eventually([&] { return is_at_rest(server); }));
}

TEST(FilmClients, SeeThatAFilmIsCut) {
  const char* const deadline = sanitized() ? "8000" : "1500";  // which the plan of its frames keeps
  Tia tia({"--port", "0", "--film-deadline-ms", deadline});
  Wire wire(tia.port());
  wire.get("/film?scene=lamp-round&width=160&height=120&fps=25&samples=64");
  const std::string answer = wire.rest();
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_FALSE(data_of(answer.substr(answer.find("\r\n\r\n") + 4))) << "no last chunk";
}

// ---- tia film -----------------------------------------------------------------------------------

TEST(FilmCommand, GivesTheServersBytesAndTellsOfItsFrames) {
  const Folder folder;
  const Finished end = run({"film", "lamp-round", "-o", folder.file("a.apng"), "--width", "24",
                            "--height", "18", "--to", "0.125", "--progress"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(end.err, HasSubstr("frame 3 of 3, "));
  EXPECT_THAT(end.err, HasSubstr(" frames/s, 0 s left"));
  const Response served =
      ask_on(shared_server().port(), "/film?scene=lamp-round&width=24&height=18&to=0.125");
  EXPECT_TRUE(file_bytes(folder.file("a.apng")) == served.body);
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.apng.part")));
}

TEST(FilmCommand, LeavesWhatWasThereWhereTheFilmIsNot) {
  const Folder folder;
  const std::string file = folder.file("a.zip"), scene = folder.file("scene.json");
  std::ofstream(file) << "before";
  std::ofstream(scene) << growing;
  EXPECT_EQ(run({"film", scene, "-o", file, "--width", "8", "--height", "6"}).status, 2);
  EXPECT_EQ(file_bytes(file), "before");
  EXPECT_FALSE(std::filesystem::exists(file + ".part"));
}

TEST(FilmCommand, RefusesANameThatSaysAnotherFormatOrNone) {
  EXPECT_THAT(run({"film", "lamp-round", "-o", "a.gif"}).err,
              HasSubstr("NAME.apng, NAME.webp, NAME.webm, NAME.zip"));
  EXPECT_THAT(run({"film", "lamp-round", "-o", "a.zip", "--format", "apng"}).err,
              HasSubstr("does not go with the file's name a.zip"));
}

}  // namespace
}  // namespace tia::test
