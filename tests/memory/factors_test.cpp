// How much memory a text takes while it is read and after, as bytes for each of its bytes. What
// memory_costs.h claims stands on these factors; each text is the worst of its kind that we know.
// Run with --gtest_filter=MemoryFactors.* to see them: each test prints its row.
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/film/denoise.h"
#include "core/film/film.h"
#include "core/film/hdr.h"
#include "core/film/pfm.h"
#include "core/film/png.h"
#include "core/film/png_text.h"
#include "core/render/explain.h"
#include "core/render/layer_film.h"
#include "core/scene/read_scene.h"
#include "core/video/vp9.h"
#include "core/video/webp_animation.h"
#include "server/operation/memory_costs.h"
#include "server/requests/recipe.h"
#include "tests/core/film/files.h"
#include "tests/core/support.h"
#include "tests/memory/scarce_memory.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

constexpr std::size_t most_values = 100'000;  // TIA_MAX_NODES
constexpr std::size_t most_bytes = 4 << 20;   // TIA_MAX_BODY_BYTES

// [item,item,…] of so many items.
std::string list_of(std::size_t count, const std::function<std::string(std::size_t)>& item) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text.append(i > 0 ? "," : "").append(item(i));
  return text + "]";
}
std::string list_of(std::size_t count, const std::string& item) {
  return list_of(count, [&](auto) { return item; });
}

/// Use: what something takes while it is made and once it is there.
struct Use {
  long peak = 0, rest = 0;
};

template <class T>
Use use_of(const std::function<T()>& make) {
  Use use;
  const long before = live_bytes();
  take_peak_bytes();
  try {
    [[maybe_unused]] const T made = make();
    use.rest = live_bytes() - before;
  } catch (const InputError&) {
  }
  use.peak = take_peak_bytes() - before;
  return use;
}

double per_byte(long bytes, const std::string& text) {
  return static_cast<double>(bytes) / static_cast<double>(text.size());
}

// ---- text -> tree ---------------------------------------------------------------------------

struct Sample {
  const char* law;
  std::string json;
  double peak, rest;  ///< the most bytes for each of the text's
};
void PrintTo(const Sample& text, std::ostream* out) { *out << text.law; }

class TreeMemory : public testing::TestWithParam<Sample> {};

TEST_P(TreeMemory, IsWithinItsFactor) {
  const Sample& text = GetParam();
  const Use use = use_of<Value>([&] { return parse_json(text.json); });
  const double peak = per_byte(use.peak, text.json), rest = per_byte(use.rest, text.json);
  std::printf("text -> tree  %-24s %8zu bytes: %6.2f while reading, %6.2f after\n", text.law,
              text.json.size(), peak, rest);
  if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
  EXPECT_LE(peak, text.peak);
  EXPECT_LE(rest, text.rest);
}

std::vector<Sample> texts() {
  const std::size_t half = most_values / 2 - 1;
  const std::string word(most_bytes - 4, 'x'), digits(most_bytes - 4, '1');
  return {
      {"Numbers", list_of(most_bytes / 2 - 1, "1"), 20.1, 20.1},
      {"NumbersOneMoreThanAPower", list_of((1 << 20) + 1, "1"), 20.1, 20.1},
      {"NestedLists", list_of(half, "[]"), 18, 14},
      {"ListsOfOne", list_of(most_values - 1, "[1]"), 24, 23},
      {"ListsOfTwo", list_of(most_values - 1, "[1,1]"), 24, 23},
      {"ListsOfThree", list_of(most_values - 1, "[1,1,1]"), 24, 23},
      {"EmptyStrings", list_of(most_values - 1, "\"\""), 14, 14},
      {"StringsOf16", list_of(most_values - 1, "\"0123456789abcdef\""), 5, 5},
      {"Nulls", list_of(most_values - 1, "null"), 10, 8.1},
      {"ObjectsOfOne", list_of(half, R"({"":0})"), 18, 18},
      {"Members",
       "{" +
           [&] {
             std::string members = list_of(
                 most_values - 1, [](std::size_t i) { return "\"" + std::to_string(i) + "\":0"; });
             return members.substr(1, members.size() - 2);
           }() +
           "}",
       10, 9},
      {"OneLongString", "[\"" + word + "\"]", 5, 1.1},
      {"OneLongNumber", "[" + digits + "]", 10, 0},
      {"NoJson", word, 10, 0},
      {"OnlyCommas", "[" + std::string(most_bytes, ','), 1, 0},
      {"NotClosed", list_of(most_bytes / 2 - 1, "1").append("]"), 20.1, 0},
  };
}
INSTANTIATE_TEST_SUITE_P(Of, TreeMemory, testing::ValuesIn(texts()), law_of);

// ---- text -> tree -> scene ------------------------------------------------------------------

class SceneMemory : public testing::TestWithParam<Sample> {};

// `rest` is the scene's alone, `peak` the tree's and the scene's together.
TEST_P(SceneMemory, IsWithinItsFactor) {
  const Sample& text = GetParam();
  std::optional<Value> tree;
  const long before = live_bytes();
  take_peak_bytes();
  tree = parse_json(text.json);
  const Use use = use_of<Scene>([&] { return read_described<Scene>(*tree); });
  const double rest = per_byte(use.rest, text.json);
  const double peak = per_byte(use.peak + live_bytes() - before, text.json);
  std::printf("tree -> scene %-24s %8zu bytes: %6.2f with the tree, %6.2f the scene\n", text.law,
              text.json.size(), peak, rest);
  EXPECT_GT(use.rest, 0) << "the text is no scene";
  if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
  EXPECT_LE(peak, text.peak);
  EXPECT_LE(rest, text.rest);
  EXPECT_LE(peak * static_cast<double>(text.json.size()),
            memory_for_text(text.json.size(), most_values));
}

std::string objects(const std::string& list) { return "{\"objects\":" + list + "}"; }

std::string mesh_text(std::size_t triangles) {
  return R"({"type":"mesh","positions":[0,0,0,1,0,0,0,1,0],"indices":)" +
         list_of(triangles, "0,1,2") + "}";
}

// {"name":{item,item,…}}, each item with a name of its own.
std::string members_of(const std::string& name, std::size_t count, const std::string& item) {
  std::string text = "{\"" + name + "\":{";
  for (std::size_t i = 0; i < count; ++i)
    text.append(i > 0 ? ",\"" : "\"").append(std::to_string(i)).append("\":").append(item);
  return text + "}}";
}

std::string voxels_text(const std::string& size, const std::string& occupied,
                        const std::string& materials) {
  return R"({"type":"voxels","size":)" + size + R"(,"occupied":)" + occupied +
         (materials.empty() ? "" : ",\"materials\":" + materials) + "}";
}

std::vector<Sample> scenes() {
  const std::string sphere = R"({"type":"sphere","radius":1,"center":[0,0,0]})";
  const std::string heart = R"({"type":"heart"})";  // no object is shorter
  const auto wearing = [](const std::string& material) {
    return "[" + voxels_text("[1,1,1]", "[[0,0,0,1]]", list_of(65'000, material)) + "]";
  };
  std::string mixed = list_of(45'000, heart);
  mixed.pop_back();
  return {
      {"Spheres", objects(list_of(20'000, sphere)), 24, 13},
      {"Hearts", objects(list_of(49'000, heart)), 46, 34},
      {"Groups", objects(list_of(10'000, R"({"type":"group","children":[)" + sphere + "]}")), 26,
       16},
      {"Copies",
       objects(list_of(9'000, R"({"type":"group","repeat":{"count":[9,9,9],"step":[1,1,1]},)"
                              R"("children":[)" +
                                  sphere + "]}")),
       26, 16},
      {"Materials", members_of("materials", most_values - 8, "{}"), 38, 31},
      {"NumberedMaterials", objects(wearing("{}")), 118, 104},  // each has a place for `radio`
      {"TexturedNumbers",
       members_of("materials", 14'000,
                  R"({"type":"principled","roughness":{"type":"noise","range":[0,1]}})"),
       24, 14},
      {"MaterialsByName", R"({"materials":{"":{}},"objects":)" + wearing("\"\"") + "}", 100, 86},
      {"Lights", "{\"lights\":" + list_of(49'000, R"({"type":"sky"})") + "}", 30, 15},
      {"Keys", members_of("keys", 49'000, R"({"":0})"), 50, 30},
      {"Mesh", objects("[" + mesh_text(690'000) + "]"), 22.1, 2.1},
      {"MixedUpToTheLimits", objects(mixed + "," + mesh_text(560'000) + "]"), 36, 9},
      {"VoxelRuns", objects("[" + voxels_text("[256,256,256]", list_of(2'000'000, "1"), "") + "]"),
       22.1, 2.1},
      {"VoxelCells", objects("[" + voxels_text("[1,1,1]", list_of(99'000, "[0,0,0]"), "") + "]"),
       23, 2},
      {"Steps",
       objects("[" + sphere.substr(0, sphere.size() - 1) + R"(,"transform":)" +
               list_of(49'000, R"({"scale":1})") + "}]"),
       24, 12},
  };
}
INSTANTIATE_TEST_SUITE_P(Of, SceneMemory, testing::ValuesIn(scenes()), law_of);

// ---- pictures -------------------------------------------------------------------------------

// A picture's pixels are three bytes each, nine while it is read, however few its file has; those
// of all of a scene's are 16 777 216 at most, 4 194 304 of one. Its base64 is kept beside them.
TEST(PictureMemory, IsThreeBytesAPixelAndItsText) {
  Image8 black(2048, 2048);
  const std::string file = base64(encode_png(black));
  const std::string text = R"({"type":"image","data":")" + file + "\"}";
  const Value tree = parse_json(text);
  const Use use = use_of<Texture>([&] { return read_described<Texture>(tree); });
  const long pixels = 2048L * 2048;
  if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
  EXPECT_LE(use.rest, 3 * pixels + static_cast<long>(file.size()) + 4096);
  EXPECT_LE(use.peak, 9 * pixels + 4 * static_cast<long>(file.size()) + (1 << 20));
}

// Of noise, whose files are the longest.
TEST(LinearMemory, IsWithinItsRowForEitherFormat) {
  const int size = 1024;
  Random random(5);
  const auto draw = [&](const auto& encode) {
    return use_of<std::string>([&] {
      LinearFilm film(size, size);
      FilmTile tile;
      tile.width = tile.height = FilmTile::size;
      for (tile.y = 0; tile.y < size; tile.y += FilmTile::size)
        for (tile.x = 0; tile.x < size; tile.x += FilmTile::size) {
          for (float& component : tile.r) component = static_cast<float>(random.unit());
          tile.g = tile.b = tile.r;
          film.put(tile);
        }
      return encode(std::move(film));
    });
  };
  const Use pfm = draw([](LinearFilm film) { return encode_pfm(film.image()); });
  const Use hdr = draw([](LinearFilm film) { return encode_hdr(std::move(film).image()); });
  if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
  const std::int64_t most = memory_for(memory_cost::linear, std::size_t{size} * size);
  EXPECT_LE(pfm.peak, most);
  EXPECT_LE(hdr.peak, most);
  EXPECT_LE(hdr.rest, 4.2 * size * size);
}

TEST(AlphaMemory, IsWithinItsRow) {
  const int size = 1024;
  Random random(6);
  const Use use = use_of<std::string>([&] {
    AlphaFilm film(size, size, {});
    FilmTile tile;
    tile.width = tile.height = FilmTile::size;
    for (tile.y = 0; tile.y < size; tile.y += FilmTile::size)
      for (tile.x = 0; tile.x < size; tile.x += FilmTile::size) {
        for (auto* components : {&tile.r, &tile.g, &tile.b, &tile.alpha})
          for (float& component : *components) component = static_cast<float>(random.unit());
        film.put(tile);
      }
    return with_text(encode_png(film.image(), {}), "a", "b");
  });
  std::printf("alpha: %.1f bytes a pixel\n", static_cast<double>(use.peak) / (size * size));
  if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
  EXPECT_LE(use.peak, memory_for(memory_cost::alpha, std::size_t{size} * size));
}

TEST(LayersMemory, IsWithinItsRow) {
  const int size = 512;
  Random random(7);
  const LayerSet some{Layer::rgba, Layer::normal, Layer::object};
  const Use use = use_of<std::string>([&] {
    LayerFilm film(size, size, some, true);
    FilmTile tile;
    tile.width = tile.height = FilmTile::size;
    for (tile.y = 0; tile.y < size; tile.y += FilmTile::size)
      for (tile.x = 0; tile.x < size; tile.x += FilmTile::size) {
        for (auto* numbers : {&tile.r, &tile.g, &tile.b, &tile.alpha})
          for (float& number : *numbers) number = static_cast<float>(random.in(0, 1e6));
        film.put(tile);
        for (const Layer feature : {Layer::normal, Layer::object}) film.put(tile, row_of(feature));
      }
    return film.encode({.width = size, .height = size, .channels = {}, .texts = {}}, ExrType::real,
                       {});
  });
  const auto numbers = static_cast<std::size_t>(some.planes()) * size * size;
  std::printf("layers: %.1f bytes a number\n",
              static_cast<double>(use.peak) / static_cast<double>(numbers));
  if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
  EXPECT_LE(use.peak, memory_for(memory_cost::layers, numbers));
}

// With a budget rounds go over the whole picture, whose sums are there all the time.
TEST(RoundsMemory, IsWithinItsRow) {
  constexpr int size = 256;
  Scene scene;
  scene.background = {0.5, 0.5, 0.5};
  const World world = compile(scene);
  RenderOptions options;
  options.integrator = IntegratorName::ambient_occlusion;
  options.samples = 64;
  options.budget.emplace();
  Pool pool(1);
  const auto use = [&] {
    return use_of<Rendered>([&] {
      return render(world, view_of(scene.camera, size, size), {0, 0, size, size}, options, pool, {},
                    [](const FilmTile&) {});
    });
  };
  const std::int64_t plain = use().peak;
  options.integrator = IntegratorName::path;
  options.samples = 32;
  options.layers = {Layer::direct, Layer::indirect, Layer::emission, Layer::variance};
  const std::int64_t layered = use().peak;
  std::printf("rounds: %.1f bytes a pixel, %.1f with 12 numbers of layers\n",
              static_cast<double>(plain) / (size * size),
              static_cast<double>(layered) / (size * size));
  if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
  constexpr std::size_t pixels = std::size_t{size} * size;
  EXPECT_LE(plain, memory_for(memory_cost::rounds, pixels));
  EXPECT_LE(layered,
            memory_for(memory_cost::rounds, pixels) + memory_for(memory_cost::layers, pixels * 12));
}

// Of frames by chance, which nothing can pack.
template <class Encoder>
long encoder_bytes(int size, const std::function<void(Encoder&, Image8&)>& add) {
  Image8 frame(size, size);
  Random random(8);
  const Use use = use_of<std::unique_ptr<Encoder>>([&] {
    auto encoder = std::make_unique<Encoder>(size, size);
    for (int k = 0; k < 3; ++k) {
      for (std::uint8_t& code : frame.rgb) code = static_cast<std::uint8_t>(random.in(0, 256));
      add(*encoder, frame);
    }
    return encoder;
  });
  std::printf("encoder: %.1f bytes a pixel\n", static_cast<double>(use.peak) / (size * size));
  return use.peak;
}

TEST(EncoderMemory, IsWithinItsRows) {
  for (const int size : {32, 512}) {
    const std::size_t pixels = static_cast<std::size_t>(size * size);
    const long webm = encoder_bytes<Vp9Encoder>(
        size, [](Vp9Encoder& encoder, Image8& frame) { encoder.encode(frame); });
    const long webp = encoder_bytes<WebpAnimation>(size, [](WebpAnimation& encoder, Image8& frame) {
      encoder.add(frame.rgb.data(), false, 0);
    });
    if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
    EXPECT_LE(webm, memory_for(memory_cost::webm, pixels) + memory_cost::encoder.bytes);
    EXPECT_LE(webp, memory_for(memory_cost::webp, pixels) + memory_cost::encoder.bytes);
  }
}

// The window and the room around it, of which there is most for small pictures.
TEST(DenoiserMemory, IsWithinItsRows) {
  for (const int size : {16, 200}) {
    const std::size_t pixels =
        std::size_t(size + 2 * denoise_margin) * std::size_t(size + 2 * denoise_margin);
    RenderOptions options;
    options.integrator = IntegratorName::ambient_occlusion;
    options.samples = 2;
    options.denoise = true;
    const World world = compile(Scene{});
    Pool pool(1);
    const Use use = use_of<Rendered>([&] {
      return render(world, view_of(Camera{}, size, size), {0, 0, size, size}, options, pool, {},
                    [](const FilmTile&) {});
    });
    std::printf("denoise: %.1f bytes a pixel\n", static_cast<double>(use.peak) / double(pixels));
    if (sanitized()) GTEST_SKIP() << "the sanitizer's pieces are larger";
    EXPECT_LE(use.peak, memory_for(memory_cost::denoise, pixels) +
                            memory_for(memory_cost::denoise_thread, 1));
  }
}

// ---- explanations ---------------------------------------------------------------------------

// Made as one tree of values and then as text.
TEST(ExplanationMemory, IsEightTimesTheLongest) {
  std::string lamps = list_of(5000, [](std::size_t i) {
    return R"({"type":"point","position":[)" + std::to_string(i) + ",20,0]}";
  });
  const Scene scene = read_scene(
      R"({"objects":[{"type":"plane","point":[0,0,-5],"normal":[0,0,1],"name":")" +
      std::string(256, 'n') + R"("},{"type":"sphere","center":[0,5,-4.9],"radius":2,"name":")" +
      std::string(256, 's') + "\"}],\"lights\":" + lamps + "}");
  RenderOptions options;
  std::size_t bytes = 0;
  const Use use = use_of<std::string>([&] {
    std::string text =
        to_json(value_of(explain(scene, compile(scene), {{0, 0, 0}, {0, 0, -1}}, options)));
    bytes = text.size();
    return text;
  });
  std::printf("explanation of %zu bytes: %ld while it is made\n", bytes, use.peak);
  EXPECT_GT(bytes, longest_explanation / 4);
  EXPECT_LE(bytes, longest_explanation);
  EXPECT_LE(use.peak, (sanitized() ? 32 : 8) * static_cast<long>(longest_explanation));
}

// ---- recipes --------------------------------------------------------------------------------

// The text of a picture that is sent back is one of JSON, however small the file is.
TEST(RecipeMemory, ATextThatUnpacksToMoreThanABodyTakesNoMoreThanABody) {
  const Config config;
  const auto body = static_cast<std::size_t>(config.max_body_bytes);
  for (const std::size_t size : {body + 1, 16 * body}) {
    const std::string bomb =
        with_text(encode_png(Image8(1, 1)), recipe_keyword, std::string(size, ' '));
    const Use use =
        use_of<Recipe>([&] { return read_recipe(recipe_text_in(bomb, config), config); });
    EXPECT_EQ(use.rest, 0);
    EXPECT_LE(use.peak, static_cast<long>(body + body / 8));
  }
}

}  // namespace
}  // namespace tia::test
