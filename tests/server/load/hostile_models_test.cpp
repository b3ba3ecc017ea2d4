// Files that are made to harm who reads them: each is refused within a second for what it is, by a
// server that takes no more memory for it, and a reader that may have little.
#include <httplib.h>
#include <unistd.h>

#include <sstream>

#include "tests/core/models/gltf_builder.h"
#include "tests/core/models/zip_files.h"
#include "tests/server/load/hostile_files.h"
#include "tests/server/model_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

// ---- texts and lists ----------------------------------------------------------------------------

std::string hostile_ply(const std::string& lines, const std::string& body = "") {
  return "ply\nformat binary_little_endian 1.0\n" + lines + "end_header\n" + body;
}
const std::string ply_xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string all_ones = zip_bytes(0xFFFFFFFF, 4);

void add_texts(HostileFiles& all) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  std::string polygon = corners + "f";
  for (int i = 0; i < 100'000; ++i) polygon += " 1 2 3";
  std::string elements;
  for (int i = 0; i < 100'000; ++i) elements += "element e" + std::to_string(i) + " 4294967295\n";
  const std::string three = std::string(36, '\0');
  const std::string faces = "element vertex 3\n" + ply_xyz + "element face 1\nproperty list ";
  const std::pair<const char*, std::string> rows[] = {
      {"ObjIndexThatWrapsAround", corners + "f 1 2 4294967297\n"},
      {"ObjIndexOf2To64", corners + "f 1 2 18446744073709551617\n"},
      {"ObjIndexBeforeTheFirst", corners + "f 1 2 -9223372036854775808\n"},
      {"ObjNoNumber", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"ObjNumberBeyondNumbers", "v 1e999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"ObjPolygonOf300000Corners", polygon + "\n"},
      {"PlyVerticesOf4G", hostile_ply("element vertex 4294967295\n" + ply_xyz)},
      {"PlyVerticesOf2To64", hostile_ply("element vertex 18446744073709551617\n" + ply_xyz)},
      {"PlyListOf4G", hostile_ply(faces + "uint int vertex_indices\n", three + all_ones)},
      {"PlyListOfMinusOne", hostile_ply(faces + "int int vertex_indices\n", three + all_ones)},
      {"PlyIndexOf4G", hostile_ply(faces + "uchar uint vertex_indices\n",
                                   three + "\3" + std::string(8, '\0') + all_ones)},
      {"PlyWithoutAnEnd", "ply\nformat ascii 1.0\n" + std::string(1'000'000, 'c')},
      {"PlyElementsOf4GWithoutEnd", hostile_ply(elements)},
      {"StlTrianglesOf4G", std::string(80, ' ') + all_ones},
      {"StlNoNumber", gltf_files::replaced(stl_text(), "vertex 1 0 0", "vertex nan 0 0")},
      {"StlNumberBeyondNumbers",
       gltf_files::replaced(stl_text(), "vertex 1 0 0", "vertex 1e999 0 0")}};
  for (const auto& [law, bytes] : rows) all.push_back({law, bytes});
}

// ---- archives and forms -------------------------------------------------------------------------

void add_archives(HostileFiles& all) {
  const auto add = [&](const std::string& law, const std::vector<ZipItem>& items) {
    all.push_back({"Zip" + law, zip_of(items)});
  };
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const ZipItem good = zip_item("a.obj", obj);
  for (const char* path : {"../a.obj", "b/../../a.obj", "..\\a.obj", "/a.obj", "C:\\a.obj"})
    add("Path_" + std::string(path), {zip_item(path, obj)});
  add("Twice", {good, good});
  ZipItem same = good, changed = good;
  same.at = 0;
  add("SharedBytes", {good, same});
  changed.local.flags = changed.central.flags = 1;
  add("Encrypted", {changed});
  changed = good;
  changed.local.method = changed.central.method = 12;
  add("OfAnotherMethod", {changed});
  changed = good;
  changed.attributes = std::uint64_t{0120777} << 16U;
  add("ALink", {changed});
  changed = good;
  changed.local.unpacked = changed.central.unpacked = 0xFFFFFFFE;
  add("SizesThatLie", {changed});
  changed = good;
  changed.central.crc ^= 1U;
  changed.local.crc ^= 1U;
  add("AnotherSum", {changed});
  add("AThousandTimesItsSize", {zip_item("a.obj", obj + std::string(20'000'000, '\n'))});
  std::vector<ZipItem> many;
  for (int i = 0; i < 20'000; ++i) many.push_back(zip_item(std::to_string(i) + ".obj", "", false));
  add("OfTwentyThousandFiles", many);
  std::string nested = zip_of({good});
  for (int i = 0; i < 10; ++i) nested = zip_of({zip_item("a.zip", nested, false)});
  all.push_back({"ZipInAZipTenTimes", nested});
  ZipShape shape;
  shape.entries = 0xFFFF;
  shape.at = 0xFFFFFFFF;
  all.push_back({"ZipOf4GEntries", zip_of({good}, shape)});
  all.push_back({"ZipCut", zip_of({good}).substr(0, 60)});
}

void add_forms(HostileFiles& all) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* path : {"../a.obj", "/etc/a.obj"})
    all.push_back({"FormPath_" + std::string(path), form_of_files({{path, obj}}), form_type});
  all.push_back({"FormTwice", form_of_files({{"a.obj", obj}, {"a.obj", obj}}), form_type});
  all.push_back({"FormOf20000Parts", form_of_files(NamedTexts(20'000, {"a", ""})), form_type});
  all.push_back({"FormWithoutAnEnd", form_of_files({{"a.obj", obj}}).substr(0, 90), form_type});
}

/// Seconds of a processor that a server and the readers that it has had have taken: what a machine
/// that does nothing else would take of time, at most.
double processor_seconds(const Tia& tia) {
  const std::string stat = file_bytes(tia.proc("stat"));
  std::istringstream rest(stat.substr(stat.rfind(')') + 1));
  std::string word;
  for (int field = 3; field <= 13; ++field) rest >> word;
  long user = 0, system = 0, readers_user = 0, readers_system = 0;
  rest >> user >> system >> readers_user >> readers_system;
  return static_cast<double>(user + system + readers_user + readers_system) /
         static_cast<double>(sysconf(_SC_CLK_TCK));
}

TEST(HostileModels, AreRefusedWithinASecondAndTakeNoMemory) {
  HostileFiles all = hostile_gltf();
  add_texts(all);
  add_archives(all);
  add_forms(all);
  EXPECT_GE(all.size(), 60U);
  Tia tia({"--port", "0", "--model-memory-bytes", std::to_string(512 << 20)});
  auto client = tia.client();
  const std::string good = to_text(gltf_files::one_triangle().glb());
  ASSERT_EQ(client.Post("/models", good, "model/gltf-binary")->status, 201);
  const long before = kilobytes(tia, "VmHWM");
  for (const HostileFile& each : all) {
    SCOPED_TRACE(each.law);
    const double started = processor_seconds(tia);
    const auto answer = client.Post("/models", each.bytes, each.type.c_str());
    ASSERT_TRUE(answer);
    EXPECT_LE(processor_seconds(tia) - started, sanitized() ? 10 : 1);
    EXPECT_TRUE(answer->status >= 400 && answer->status < 500) << answer->status << answer->body;
    EXPECT_THAT(answer->body, testing::Not(testing::HasSubstr("TIA_MODEL_MEMORY_BYTES")));
  }
  EXPECT_LE(kilobytes(tia, "VmHWM") - before, (40 << 10) + sanitizers_kilobytes());
  RecordProperty("kilobytes", static_cast<int>(kilobytes(tia, "VmHWM") - before));
  const Response metrics = tia.get("/metrics");
  EXPECT_EQ(series_of(metrics.body).at("tia_model_reader_deaths_total"), 0);
  EXPECT_EQ(client.Post("/models", good, "model/gltf-binary")->status, 200);
}

}  // namespace
}  // namespace tia::test
