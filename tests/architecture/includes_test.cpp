// The architecture's arrows, read off the #include lines and a few words of core/ and server/, and
// off the import lines of web/.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

// Core's folders from top to bottom: each may include itself and what stands above it. Core's
// own file, version.h, stands below them all.
const std::vector<std::string> core_layers = {
    "math",   "parallel", "input",     "film",        "video",  "formulas",
    "boxes",  "shapes",   "materials", "lights",      "models", "scene",
    "motion", "accel",    "radio",     "integrators", "render"};
// The server's rooms likewise; its own few files, such as main, stand below them all.
const std::vector<std::string> server_layers = {"http",   "contract", "operation",
                                                "stores", "access",   "requests",
                                                "jobs",   "handlers", "commands"};
// The page's rooms likewise; what wires them, main.js, stands below them all.
const std::vector<std::string> web_layers = {"space",  "state",  "words", "picture",
                                             "studio", "panels", "docs"};

// Libraries, by the start of their headers' names, and the only places that may include them.
struct Wrapped {
  std::string_view header;
  std::vector<std::string_view> places;
};
const std::vector<Wrapped> libraries = {
    {"nlohmann/", {"core/input/"}},
    {"stb", {"core/film/"}},
    {"libdeflate",
     {"core/film/", "core/input/packed_text.cpp", "core/models/zip", "core/video/stored_zip.cpp"}},
    {"webp/", {"core/models/webp.cpp", "core/video/webp_animation.cpp"}},
    {"vpx/", {"core/video/vp9.cpp"}},
    {"jpeglib", {"core/film/jpeg.cpp"}},
    {"draco/", {"core/models/draco.cpp"}},
    {"meshoptimizer", {"core/models/meshopt.cpp"}},
    {"btBullet", {"core/motion/rigid.cpp"}},
    {"seccomp", {"server/operation/confine.cpp"}},
    {"sleef", {"core/math/"}},
    {"xsimd", {"core/math/registers.h"}},
    {"immintrin", {"core/math/lanes.h", "core/math/wide.h", "core/math/octet.h"}},
    {"httplib", {"server/http/"}},
    {"CLI/", {"server/commands/command_line.cpp"}},
    {"asio", {"server/http/", "server/stores/redis_socket.cpp"}},
    {"hiredis", {"server/stores/redis_reply.cpp"}},
    {"prometheus/", {"server/operation/metrics.cpp"}},
    {"sqlite", {"server/stores/database.cpp"}},
    {"png.h", {}},  // the tests' own readers of what the product writes
    {"zlib.h", {}},
    {"openssl/",
     {"server/access/secrets.cpp", "server/stores/digest.cpp", "server/stores/objects_parts.cpp"}},
};

// What core must not know: sockets, clocks, the environment, logs, files, chance.
const std::vector<std::string_view> headers_outside_core = {
    "chrono",     "ctime",    "time.h",   "sys/",     "netinet/", "arpa/",  "netdb.h",
    "unistd.h",   "poll.h",   "syslog.h", "iostream", "fstream",  "cstdio", "stdio.h",
    "filesystem", "signal.h", "csignal",  "random",   "server/"};
const std::regex words_outside_core(
    R"(\b(getenv|setenv|chrono|clock_gettime|gettimeofday|time\(|cout|cerr|clog|printf|fopen|)"
    R"(random_device|rand\(|syslog|sleep_for|sleep_until|socket\())");
// But for the time that threads take, which decides who works next, never what comes out.
constexpr std::string_view timekeeper = "core/parallel/hands.cpp";
// And for the size of the pages that memory comes in.
constexpr std::string_view pager = "core/boxes/huge_pages.h";

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}
// Of "core/math/vec3.h" that of "math".
std::size_t layer_of(std::string_view path) {
  const std::vector<std::string>& layers = starts_with(path, "core/")  ? core_layers
                                           : starts_with(path, "web/") ? web_layers
                                                                       : server_layers;
  const std::string_view rest = path.substr(path.find('/') + 1);
  const auto slash = rest.find('/');
  if (slash == rest.npos) return layers.size();
  const auto found = std::find(layers.begin(), layers.end(), rest.substr(0, slash));
  return static_cast<std::size_t>(found - layers.begin());
}

bool points_back(std::string_view file, std::string_view needed) {
  return layer_of(needed) > layer_of(file);
}

// Why a file may not include a header, or "".
std::string refusal(const std::string& file, const std::string& header) {
  for (const auto& [library, places] : libraries) {
    if (!starts_with(header, library)) continue;
    const auto inside = [&](std::string_view place) { return starts_with(file, place); };
    if (std::none_of(places.begin(), places.end(), inside)) return "a library outside its place";
  }
  if (starts_with(file, "server/")) {
    const bool back = starts_with(header, "server/") && points_back(file, header);
    return back ? "an arrow that points back up" : "";
  }
  if (file == timekeeper && header == "chrono") return "";
  if (file == pager && header == "sys/mman.h") return "";
  for (const std::string_view each : headers_outside_core)
    if (header == each || (each.back() == '/' && starts_with(header, each))) return "not for core";
  if (starts_with(header, "core/") && points_back(file, header))
    return "an arrow that points back up";
  return "";
}

struct Source {
  std::string path, text;  // the path below the repository's root
};
std::vector<Source> sources(const std::string& folder,
                            const std::set<std::string>& extensions = {".h", ".cpp"}) {
  std::vector<Source> all;
  const fs::path root = TIA_SOURCE_DIR;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    if (!extensions.contains(entry.path().extension())) continue;
    std::ifstream file(entry.path());
    std::ostringstream text;
    text << file.rdbuf();
    all.push_back({fs::relative(entry.path(), root).generic_string(), text.str()});
  }
  return all;
}

std::vector<std::string> includes_of(const std::string& text) {
  static const std::regex line(R"re((^|\n)\s*#\s*include\s*["<]([^">]+)[">])re");
  std::vector<std::string> headers;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
    headers.push_back((*it)[2]);
  return headers;
}

// The modules that a module imports, below the repository's root.
std::vector<std::string> imports_of(const Source& module) {
  static const std::regex import(R"re(\b(from|import)\s*\(?\s*['"](\.[^'"]+)['"])re");
  std::vector<std::string> modules;
  for (std::sregex_iterator it(module.text.begin(), module.text.end(), import), end; it != end;
       ++it) {
    const fs::path path = fs::path(module.path).parent_path() / std::string((*it)[2]);
    modules.push_back(path.lexically_normal().generic_string());
  }
  return modules;
}

std::string without_comments(const std::string& text) {
  static const std::regex comment(R"(//[^\n]*)");
  return std::regex_replace(text, comment, "");
}

// ---- the tree -----------------------------------------------------------------------------------

TEST(Includes, EveryArrowPointsTheRightWay) {
  int seen = 0;
  for (const char* folder : {"core", "server"}) {
    for (const Source& source : sources(folder)) {
      for (const std::string& header : includes_of(source.text)) {
        EXPECT_EQ(refusal(source.path, header), "") << source.path << " includes " << header;
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 200) << "the tree was not found";
}

TEST(Includes, OurOwnHeadersAreNamedFromTheRootAndExist) {
  for (const char* folder : {"core", "server"}) {
    for (const Source& source : sources(folder)) {
      static const std::regex quoted(R"re((^|\n)\s*#\s*include\s*"([^"]+)")re");
      for (std::sregex_iterator it(source.text.begin(), source.text.end(), quoted), end; it != end;
           ++it)
        EXPECT_TRUE(fs::exists(fs::path(TIA_SOURCE_DIR) / std::string((*it)[2])))
            << source.path << " includes " << (*it)[2];
    }
  }
}

TEST(Includes, FoldersAreThoseOfTheLists) {
  const std::set<std::string> of_data{"server/deploy", "web/scenes", "web/models"};
  const auto check = [&](const std::string& folder, const std::vector<std::string>& layers) {
    for (const auto& entry : fs::directory_iterator(fs::path(TIA_SOURCE_DIR) / folder)) {
      const std::string name = entry.path().filename();
      if (!entry.is_directory() || of_data.contains(folder + "/" + name)) continue;
      EXPECT_NE(std::find(layers.begin(), layers.end(), name), layers.end()) << name;
    }
  };
  check("core", core_layers);
  check("server", server_layers);
  check("web", web_layers);
}

// Types that a file defines for others, with their namespaces: "tia::server::Route".
std::set<std::string> types_of(const std::string& text) {
  static const std::regex line(
      R"re(^(?:namespace ([\w:]*) ?\{|\}  // namespace.*|)re"
      R"re((?:struct|class|enum class) (\w+)(?: final)?(?: :[^:;{].*)? ?\{.*)$)re");
  std::vector<std::string> names;
  std::set<std::string> types;
  std::istringstream lines(text);
  for (std::string each; std::getline(lines, each);) {
    std::smatch is;
    if (!std::regex_match(each, is, line)) continue;
    if (is[2].matched) {
      std::string whole;
      for (const std::string& name : names) whole.append(name).append("::");
      if (std::count(names.begin(), names.end(), "") == 0) types.insert(whole + is[2].str());
    } else if (is[1].matched) names.push_back(is[1]);
    else names.pop_back();
  }
  return types;
}

// Of two that are not, a program may take one's members for the other's wherever it was compiled
// with one of them alone, and no compiler says so (C++20, [basic.def.odr]).
TEST(Types, OfOneNameAreOne) {
  std::map<std::string, std::string> places;
  for (const char* folder : {"core", "server"})
    for (const Source& source : sources(folder))
      for (const std::string& type : types_of(source.text)) {
        const auto [place, is_new] = places.emplace(type, source.path);
        EXPECT_TRUE(is_new) << type << " is in " << place->second << " and in " << source.path;
      }
  EXPECT_GT(places.size(), 500U) << "the tree was not found";
  EXPECT_EQ(types_of("namespace a {\nnamespace {\nstruct B {};\n}  // namespace\nclass C final : D "
                     "{\n}  // namespace a\n"),
            std::set<std::string>{"a::C"});
}

// A header and its source are one: who includes the header needs the source.
using Graph = std::map<std::string, std::set<std::string>>;
std::string unit_of(std::string_view path) { return std::string(path.substr(0, path.rfind('.'))); }

// One circle of the graph, "a -> b -> a", or "".
std::string circle_in(const Graph& graph) {
  std::set<std::string> done;
  std::vector<std::string> way;
  std::function<std::string(const std::string&)> from =
      [&](const std::string& unit) -> std::string {
    if (const auto met = std::find(way.begin(), way.end(), unit); met != way.end()) {
      std::string circle;
      for (auto each = met; each != way.end(); ++each) circle += *each + " -> ";
      return circle + unit;
    }
    if (!done.insert(unit).second) return "";
    way.push_back(unit);
    const auto known = graph.find(unit);
    if (known != graph.end()) {
      for (const std::string& next : known->second)
        if (std::string circle = from(next); !circle.empty()) return circle;
    }
    way.pop_back();
    return "";
  };
  for (const auto& [unit, needs] : graph)
    if (std::string circle = from(unit); !circle.empty()) return circle;
  return "";
}

TEST(Includes, FormNoCircles) {
  Graph graph;
  for (const char* folder : {"core", "server"})
    for (const Source& source : sources(folder))
      for (const std::string& header : includes_of(source.text))
        if (starts_with(header, "core/") || starts_with(header, "server/"))
          if (unit_of(header) != unit_of(source.path))
            graph[unit_of(source.path)].insert(unit_of(header));
  EXPECT_GT(graph.size(), 100U);
  EXPECT_EQ(circle_in(graph), "");
}

TEST(Imports, ExistPointTheRightWayAndFormNoCircles) {
  Graph graph;
  for (const Source& module : sources("web", {".js"}))
    for (const std::string& needed : imports_of(module)) {
      EXPECT_TRUE(fs::exists(fs::path(TIA_SOURCE_DIR) / needed))
          << module.path << " imports " << needed;
      EXPECT_FALSE(points_back(module.path, needed)) << module.path << " imports " << needed;
      graph[module.path].insert(needed);
    }
  EXPECT_GT(graph.size(), 40U);
  EXPECT_EQ(circle_in(graph), "");
}

TEST(Includes, CoreNamesNoClockNoEnvironmentNoLogAndNoChance) {
  for (const Source& source : sources("core")) {
    std::string code = without_comments(source.text);
    if (source.path == timekeeper) code = std::regex_replace(code, std::regex("chrono"), "");
    std::smatch found;
    EXPECT_FALSE(std::regex_search(code, found, words_outside_core))
        << source.path << " says " << found.str();
  }
}

TEST(Includes, EveryHeaderGuardsItself) {
  for (const char* folder : {"core", "server"}) {
    for (const Source& source : sources(folder)) {
      if (!source.path.ends_with(".h")) continue;
      EXPECT_NE(source.text.find("#pragma once"), std::string::npos) << source.path;
    }
  }
}

// ---- the rules themselves: each must be able to fail
// ----------------------------------------------

TEST(IncludeRules, ArrowsBackUpAreSeen) {
  EXPECT_NE(refusal("core/math/vec3.h", "core/input/value.h"), "");
  EXPECT_NE(refusal("core/shapes/simple/sphere.h", "core/scene/scene.h"), "");
  EXPECT_NE(refusal("core/accel/world.cpp", "core/render/render.h"), "");
  EXPECT_NE(refusal("core/scene/scene.h", "core/elsewhere/x.h"), "");
  EXPECT_NE(refusal("core/render/render.cpp", "server/operation/config.h"), "");
  EXPECT_EQ(refusal("core/input/codec.h", "core/math/vec3.h"), "");
  EXPECT_EQ(refusal("core/math/ray.h", "core/math/vec3.h"), "");
  EXPECT_NE(refusal("server/http/head.cpp", "server/contract/problem.h"), "");
  EXPECT_NE(refusal("server/stores/gallery.cpp", "server/requests/recipe.h"), "");
  EXPECT_NE(refusal("server/handlers/backend.cpp", "server/commands/serving.h"), "");
  EXPECT_EQ(refusal("server/handlers/dispatch.cpp", "core/render/render.h"), "");
  EXPECT_EQ(refusal("server/main.cpp", "server/handlers/backend.h"), "");
  EXPECT_TRUE(points_back("web/state/address.js", "web/picture/server.js"));
  EXPECT_TRUE(points_back("web/panels/why.js", "web/main.js"));
  EXPECT_FALSE(points_back("web/studio/studio.js", "web/space/view.js"));
  EXPECT_FALSE(points_back("web/main.js", "web/panels/why.js"));
}

TEST(IncludeRules, CirclesAreSeen) {
  EXPECT_EQ(circle_in({{"a", {"b", "c"}}, {"b", {"c"}}}), "");
  EXPECT_EQ(circle_in({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}), "b -> c -> b");
}

TEST(IncludeRules, LibrariesOutsideTheirPlaceAreSeen) {
  EXPECT_NE(refusal("core/scene/keys.cpp", "nlohmann/json.hpp"), "");
  EXPECT_NE(refusal("server/handlers/dispatch.cpp", "nlohmann/json.hpp"), "");
  EXPECT_NE(refusal("server/requests/draw.cpp", "stb/stb_image_write.h"), "");
  EXPECT_NE(refusal("core/render/render.cpp", "xsimd/xsimd.hpp"), "");
  EXPECT_NE(refusal("server/handlers/dispatch.cpp", "httplib.h"), "");
  EXPECT_NE(refusal("server/http/message.h", "CLI/CLI.hpp"), "");
  EXPECT_NE(refusal("server/stores/scene_store.cpp", "sqlite3.h"), "");
  EXPECT_EQ(refusal("core/input/parse.cpp", "nlohmann/json.hpp"), "");
  EXPECT_EQ(refusal("server/http/http_server.cpp", "httplib.h"), "");
  EXPECT_NE(refusal("server/operation/config.cpp", "CLI/CLI.hpp"), "");
  EXPECT_EQ(refusal("server/commands/command_line.cpp", "CLI/CLI.hpp"), "");
}

TEST(IncludeRules, ClocksSocketsAndLogsInCoreAreSeen) {
  for (const char* header :
       {"chrono", "ctime", "sys/socket.h", "sys/time.h", "iostream", "netdb.h"}) {
    EXPECT_NE(refusal("core/render/render.cpp", header), "") << header;
    EXPECT_EQ(refusal("server/main.cpp", header), "") << header;
  }
  EXPECT_EQ(refusal("core/parallel/hands.cpp", "chrono"), "");
  EXPECT_NE(refusal("core/parallel/hands.h", "chrono"), "");
  EXPECT_NE(refusal("core/parallel/hands.cpp", "ctime"), "");
  const auto says = [](const std::string& code) {
    return std::regex_search(without_comments(code), words_outside_core);
  };
  EXPECT_TRUE(says("auto t = std::chrono::steady_clock::now();"));
  EXPECT_TRUE(says("if (std::getenv(\"TIA\")) return;"));
  EXPECT_TRUE(says("std::cerr << x;"));
  EXPECT_FALSE(says("// no clock: std::chrono is for hosts"));
  EXPECT_FALSE(says("const double operand(3), timed = runtime(2);"));
}

TEST(IncludeRules, IncludeLinesOfBothKindsAreRead) {
  EXPECT_EQ(includes_of("#include <a>\n  # include \"b/c.h\"\n// #include <not>\nint x;"),
            (std::vector<std::string>{"a", "b/c.h"}));
}

TEST(IncludeRules, ImportLinesOfAllKindsAreRead) {
  const std::string text =
      "import a from './a.js';\nimport {\n  b,\n} from \"../b.js\";\nimport '../c/d.js';\n"
      "export { e } from './e.js';\nconst f = await import('./f.js');\nimport g from 'node:g';\n";
  EXPECT_EQ(imports_of({"web/room/x.js", text}),
            (std::vector<std::string>{"web/room/a.js", "web/b.js", "web/c/d.js", "web/room/e.js",
                                      "web/room/f.js"}));
}

}  // namespace
