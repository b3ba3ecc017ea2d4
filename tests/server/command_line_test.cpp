// The command line: flags, variables, --help, --version, --healthcheck. Bad use exits with 2.
#include "core/version.h"
#include "server/operation/config.h"
#include "server/requests/picture_request.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

TEST(CommandLine, VersionIsTheVersion) {
  const Finished end = run({"--version"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.out, std::string("Tia ") + version() + "\n");
}

TEST(CommandLine, HelpNamesEveryOptionItsVariableItsRangeAndDefault) {
  for (const Process::Words& words : {Process::Words{"--help"}, {"serve", "--help"}}) {
    const Finished end = run(words);
    EXPECT_EQ(end.status, 0);
    for (const OptionRow& row : option_rows())
      for (const std::string& part : {row.flag, row.variable, row.allowed, row.value})
        EXPECT_THAT(end.out, HasSubstr(part));
  }
  const Finished end = run({"--help"});
  for (const char* part : {"--healthcheck", "--version", "serve", "render"})
    EXPECT_THAT(end.out, HasSubstr(part));
}

TEST(CommandLine, HelpOfRenderNamesEveryParameter) {
  const Finished end = run({"render", "--help"});
  EXPECT_EQ(end.status, 0);
  for (const char* part : {"scene", "--key", "--light", "--width", "--height", "--crop",
                           "--integrator", "--transfer", "--format", "--seed", "--threads", "-o",
                           "an integer from 1 to 64", "png, pfm, hdr, tiff, exr", "srgb"})
    EXPECT_THAT(end.out, HasSubstr(part));
}

struct Use {
  const char* law;
  Process::Words arguments;
  const char* named;
  Process::Words environment = {};
};
void PrintTo(const Use& use, std::ostream* out) { *out << use.law; }

class BadUse : public testing::TestWithParam<Use> {};

TEST_P(BadUse, Exits2SayingWhatIsWrong) {
  const Finished end = run(GetParam().arguments, GetParam().environment);
  EXPECT_EQ(end.status, 2);
  EXPECT_EQ(end.out, "");
  EXPECT_THAT(end.err, HasSubstr(GetParam().named));
}

const Use uses[] = {
    {"UnknownFlag", {"--prot", "0"}, "--prot"},
    {"UnknownCommand", {"paint"}, "paint"},
    {"EmptyHost", {"--host", ""}, "--host"},
    {"TwoCommands", {"serve", "render"}, "render"},
    {"FlagWithoutValue", {"--port"}, "--port"},
    {"FlagTwice", {"--port", "1", "--port", "2"}, "--port"},
    {"PortTooLarge", {"--port", "65536"}, "--port"},
    {"PortNamesItsRange", {"--port", "65536"}, "65535"},
    {"PortNegative", {"--port=-1"}, "--port"},
    {"PortWord", {"--port", "http"}, "http"},
    {"PortEmpty", {"--port", ""}, "--port"},
    {"ThreadsZero", {"--threads", "0"}, "--threads"},
    {"BodyTooSmall", {"--max-body-bytes", "1023"}, "--max-body-bytes"},
    {"PixelsTooMany", {"--max-pixels", "268435457"}, "--max-pixels"},
    {"VariableWord", {}, "TIA_PORT", {"TIA_PORT=http"}},
    {"VariableEmpty", {}, "TIA_PORT", {"TIA_PORT="}},
    {"VariableOutOfRange", {}, "TIA_THREADS", {"TIA_THREADS=65"}},
    {"VariableNamesItsRange", {}, "64", {"TIA_THREADS=65"}},
    {"VariableOfPixels", {}, "TIA_MAX_PIXELS", {"TIA_MAX_PIXELS=0"}},
    {"VariableOfKubernetes", {}, "enableServiceLinks", {"TIA_PORT=tcp://10.0.0.1:8080"}},
    {"ProxyThatIsNone", {"--trusted-proxies", "10.0.0.1,proxy"}, "\"proxy\""},
    {"OriginWithAPath", {}, "TIA_CORS_ORIGINS", {"TIA_CORS_ORIGINS=https://a.example/"}},
    {"BadOptionBesidesPrintConfig", {"--print-config", "--port", "x"}, "--port"},
    {"RenderWithoutScene", {"render", "-o", "x.png"}, "scene"},
    {"RenderWithoutFile", {"render", "thesis"}, "--output"},
    {"VariableBesidesHealthcheck", {"--healthcheck"}, "TIA_PORT", {"TIA_PORT=99999"}},
};
INSTANTIATE_TEST_SUITE_P(Of, BadUse, testing::ValuesIn(uses), law_of);

TEST(CommandLine, AVariableSetsAnOptionAndAFlagWins) {
  const Tia by_variable({}, {"TIA_PORT=0", "TIA_MAX_PIXELS=48"});
  EXPECT_EQ(by_variable.get("/render?width=8&height=6").status, 200);
  EXPECT_EQ(by_variable.get("/render?width=7&height=7").status, 422);
  const Tia by_flag({"--port", "0", "--max-pixels", "49"},
                    {"TIA_PORT=99999999", "TIA_MAX_PIXELS=48"});
  EXPECT_EQ(by_flag.get("/render?width=7&height=7").status, 200);
}

TEST(CommandLine, PrintConfigPrintsTheValuesInForceAndExits) {
  Config config;
  config.port = 9000;
  config.max_pixels = 48;
  for (const Process::Words& words : {Process::Words{"--print-config", "--port", "9000"},
                                      {"serve", "--port", "9000", "--print-config"}}) {
    const Finished end = run(words, {"TIA_PORT=1", "TIA_MAX_PIXELS=48"});
    EXPECT_EQ(end.status, 0);
    EXPECT_EQ(end.out, env_file(config));
    EXPECT_EQ(end.err, "");
  }
}

TEST(CommandLine, AnUnknownVariableIsWarnedOfAndDoesNoHarm) {
  const Finished end = run({"--print-config"}, {"TIA_PROT=9000"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.out, env_file({}));
  EXPECT_EQ(end.err, "tia: TIA_PROT is no option, did you mean TIA_PORT?\n");
}

TEST(Healthcheck, Is0WhereTheServerLivesAnd1WhereNoneDoes) {
  std::string port;
  {
    const Tia tia;
    port = std::to_string(tia.port());
    EXPECT_EQ(run({"--healthcheck", "--port", port}).status, 0);
    EXPECT_EQ(run({"--healthcheck"}, {"TIA_PORT=" + port}).status, 0);
  }
  EXPECT_EQ(run({"--healthcheck", "--port", port}).status, 1);
}

TEST(Healthcheck, AsksTheAddressThatIsListenedOn) {
  const Tia everywhere({"--host", "0.0.0.0", "--port", "0"});
  EXPECT_EQ(run({"--healthcheck", "--host", "0.0.0.0", "--port", std::to_string(everywhere.port())})
                .status,
            0);
  const Tia second({"--host", "127.0.0.2", "--port", "0"});  // all of 127/8 is this machine
  EXPECT_EQ(
      run({"--healthcheck", "--host", "127.0.0.2", "--port", std::to_string(second.port())}).status,
      0);
}

}  // namespace
}  // namespace tia::test
