// Models are read by a process that may die of them, while everybody else goes on.
#include "server/stores/model_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstring>
#include <fstream>
#include <thread>

#include "core/film/png.h"
#include "core/models/archive.h"
#include "core/parallel/stopped.h"
#include "server/stores/model_exchange.h"
#include "tests/sanitizer.h"
#include "tests/server/process_support.h"

namespace tia::server {
namespace {

using test::Folder;
using testing::HasSubstr;

const std::string tetrahedron = R"(solid part
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 1 0 vertex 1 0 0 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 0 1 endloop endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 1 vertex 0 1 0 endloop endfacet
facet normal 0 0 0 outer loop vertex 1 0 0 vertex 0 1 0 vertex 0 0 1 endloop endfacet
endsolid part
)";

ModelFiles files_of(const std::string& text) {
  return {{{"part", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}}}, 0};
}
// The program itself, with that much memory and time.
ModelReader reader(std::uint64_t memory_bytes = std::uint64_t{1} << 30U, unsigned cpu_s = 20) {
  return ModelReader({memory_bytes, cpu_s}, test::tia_program());
}

/// A program that answers what a script writes, whatever it is asked.
class Answering {
 public:
  explicit Answering(const std::string& script) {
    std::ofstream(file_) << "#!/bin/sh\ncat > /dev/null\n" << script << '\n';
    chmod(file_.c_str(), 0700);
  }
  KeptModel read(const std::stop_token& stop = {}) const {
    return ModelReader({std::uint64_t{1} << 20U, 1}, file_).read(files_of(tetrahedron), {}, stop);
  }

 private:
  Folder folder_;
  std::string file_ = folder_.file("reader");
};

TEST(ModelReader, ReadsWhatTheSameCodeReadsHere) {
  const KeptModel apart = reader().read(files_of(tetrahedron), {});
  EXPECT_EQ(*apart.model, read_model(files_of(tetrahedron)));
  EXPECT_EQ(apart.model->meshes[0].parts[0].triangles(), 4U);
}

TEST(ModelReader, TellsTheFaultsThatTheSameCodeTells) {
  for (const std::string& text : {std::string("nothing that is known"),
                                  std::string("solid x\nfacet"), tetrahedron.substr(0, 200)}) {
    std::string here, apart;
    try {
      read_model(files_of(text));
    } catch (const InputError& error) {
      here = error.what();
    }
    try {
      reader().read(files_of(text), {});
    } catch (const InputError& error) {
      apart = error.what();
    }
    EXPECT_FALSE(here.empty());
    EXPECT_EQ(apart, here);
  }
}

TEST(ModelReader, TakesItsLimitsAlong) {
  EXPECT_THROW(reader().read(files_of(tetrahedron), {.triangles = 3}), InputError);
  EXPECT_NO_THROW(reader().read(files_of(tetrahedron), {.triangles = 4}));
}

TEST(ModelReader, NamesTheOptionWhereMemoryIsShort) {
  if (test::sanitized()) GTEST_SKIP() << "sanitizers need more than a confined process may";
  std::string large;
  while (large.size() < 100'000'000) large += std::string(1'000'000, ' ');
  try {
    reader(90'000'000).read(files_of("solid " + large), {});  // less than the file
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().front().kind, FaultKind::limit);
    EXPECT_THAT(error.what(), HasSubstr("TIA_MODEL_MEMORY_BYTES"));
  }
}

TEST(ModelReader, SaysWhenItsTimeWasOver) {
  try {
    Answering("kill -XCPU $$").read();
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().front().kind, FaultKind::limit);
    EXPECT_THAT(error.what(), HasSubstr("1 s of a processor"));
  }
}

TEST(ModelReader, ThatDiesIsNoFaultOfTheRequest) {
  for (const char* script : {"kill -SYS $$", "kill -SEGV $$", "kill -KILL $$", "exit 1", "exit 4"})
    EXPECT_THROW(Answering(script).read(), ReaderDied) << script;
}

TEST(ModelReader, BelievesNoAnswerThatDoesNotFit) {
  for (const char* script :
       {"printf ''", "printf M", "printf Mxxxxxxxxxxxxxxxx", "printf X", "printf F", "printf 'F{'",
        "printf 'F[]'", "printf 'F[1]'", R"(printf 'F[{"kind":99,"pointer":"","allowed":""}]')",
        R"(printf 'F[{"kind":1}]')", "printf M; head -c 100000 /dev/zero",
        "printf M; head -c 100000 /dev/urandom", "cat /dev/zero"})
    EXPECT_THROW(Answering(script).read(), ReaderDied) << script;
}

// What the process does, done here.
std::vector<std::uint8_t> answer_here(const ModelFiles& files, const ModelLimits& limits = {}) {
  const std::string head = request_head(files, limits);
  std::vector<std::uint8_t> request(head.begin(), head.end());
  for (const ModelFile& each : files.all)
    request.insert(request.end(), each.bytes.begin(), each.bytes.end());
  std::vector<std::uint8_t> bytes;
  answer_to(request).each_part(
      [&](ModelBytes part) { bytes.insert(bytes.end(), part.begin(), part.end()); });
  return bytes;
}

TEST(ModelExchange, GivesTheModelOrItsFaults) {
  const KeptModel kept = model_of(answer_here(files_of(tetrahedron)), {});
  EXPECT_EQ(*kept.model, read_model(files_of(tetrahedron)));
  EXPECT_TRUE(kept.images.empty());
  for (const std::string& text : {std::string("unknown"), tetrahedron.substr(0, 100)}) {
    try {
      model_of(answer_here(files_of(text)), {});
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_FALSE(error.faults().empty());
    }
  }
  EXPECT_THROW(model_of(answer_here(files_of(tetrahedron), {.triangles = 1}), {}), InputError);
}

TEST(ModelExchange, RefusesWhatIsNoRequest) {
  const ModelFiles files = files_of(tetrahedron);
  const std::string head = request_head(files, {});
  for (const std::string& bad : {std::string(), std::string("{}"), std::string("{}\n"), head,
                                 std::string("{\"files\":[],\"main\":0}\n"), std::string("[]\n")}) {
    const std::vector<std::uint8_t> bytes(bad.begin(), bad.end());
    EXPECT_THROW(answer_to(bytes), std::exception) << bad;
  }
}

// ---- pictures -----------------------------------------------------------------------------------

// A point cloud whose texture is a picture of these pixels.
const std::string textured =
    "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 1\nproperty float x\n"
    "property float y\nproperty float z\nproperty float s\nproperty float t\nend_header\n"
    "1 2 3 0 0\n";
std::vector<std::uint8_t> picture_of(int width, int height) {
  Image8 image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(i * 7);
  const std::string file = encode_png(image);
  return {file.begin(), file.end()};
}
ModelFiles with_picture(const std::vector<std::uint8_t>& picture) {
  ModelFiles files = files_of(textured);
  files.all.push_back({"skin.png", picture});
  return files;
}

TEST(ModelReader, DecodesPicturesApart) {
  const std::vector<std::uint8_t> picture = picture_of(5, 3);
  const KeptModel apart = reader().read(with_picture(picture), {});
  ASSERT_EQ(apart.images.size(), 1U);
  EXPECT_EQ(apart.images[0]->width, 5);
  EXPECT_EQ(apart.images[0]->height, 3);
  for (std::size_t i = 0; i < 15; ++i)
    for (std::size_t c = 0; c < 4; ++c)
      ASSERT_EQ(apart.images[0]->rgba.at(i * 4 + c),
                c == 3 ? 255 : static_cast<std::uint8_t>((i * 3 + c) * 7));
  EXPECT_EQ(apart.model->images.at(0).name, "skin.png");
  EXPECT_TRUE(apart.model->images[0].file.empty());
}

TEST(ModelReader, TellsThePicturesFaults) {
  const std::vector<std::uint8_t> picture = picture_of(5, 3);
  const auto fault_of = [](const ModelFiles& files, const ModelLimits& limits) {
    try {
      reader().read(files, limits);
    } catch (const InputError& error) {
      return error.faults().at(0);
    }
    return Fault{};
  };
  const std::vector<std::uint8_t> half(picture.begin(), picture.begin() + 40);
  const Fault broken = fault_of(with_picture(half), {}),
              large = fault_of(with_picture(picture), {.texture_pixels = 14});
  EXPECT_EQ(broken.pointer, "/images/0");
  EXPECT_EQ(broken.kind, FaultKind::wrong_type);
  EXPECT_EQ(large.pointer, "/images/0");
  EXPECT_EQ(large.kind, FaultKind::limit);
}

// What a reader that was taken over could write.
TEST(ModelExchange, ChecksPicturesAsAStrangers) {
  const std::vector<std::uint8_t> picture = picture_of(5, 3);
  const std::vector<std::uint8_t> good = answer_here(with_picture(picture));
  EXPECT_EQ(model_of(good, {}).images.at(0)->rgba.size(), 60U);
  EXPECT_THROW(model_of(good, {.texture_pixels = 14}), NoAnswer);
  EXPECT_THROW(model_of(good, {.texture_side = 4}), NoAnswer);
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_THROW(model_of(std::span(good).first(size), {}), NoAnswer) << size;
  std::vector<std::uint8_t> other = good;
  other.push_back(0);
  EXPECT_THROW(model_of(other, {}), NoAnswer);
  other = good;
  other[good.size() - 61] = 0xFF;  // the height's last byte
  EXPECT_THROW(model_of(other, {}), NoAnswer);
}

// An archive that is whole but does not fit together.
TEST(ModelReader, ChecksTheModelAsAStrangers) {
  Model model = read_model(files_of(tetrahedron));
  model.meshes[0].parts[0].indices[0] = 1'000'000;
  std::vector<std::uint8_t> archive;
  write_archive(model,
                [&](ModelBytes part) { archive.insert(archive.end(), part.begin(), part.end()); });
  std::vector<std::uint8_t> answer{'M', 0, 0, 0, 0, 0, 0, 0, 0};
  const std::uint64_t length = archive.size();
  std::memcpy(answer.data() + 1, &length, sizeof length);
  answer.insert(answer.end(), archive.begin(), archive.end());
  EXPECT_THROW(model_of(answer, {}), NoAnswer);
}

TEST(ModelReader, IsGivenUpWithWhoAsked) {
  std::stop_source source;
  const std::jthread asker([&] { source.request_stop(); });
  EXPECT_THROW(Answering("sleep 100").read(source.get_token()), Stopped);
}

TEST(ModelReader, OthersGoOnWhileOneDies) {
  const Answering dying("sleep 0.1; kill -SEGV $$");
  std::jthread other([&] { EXPECT_THROW(dying.read(), ReaderDied); });
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(reader().read(files_of(tetrahedron), {}).model->meshes.size(), 1U);
}

}  // namespace
}  // namespace tia::server
