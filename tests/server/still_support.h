// What tests of /still share: a model that is kept, and its stills.
#pragma once

#include "tests/core/png/png_reader.h"
#include "tests/server/model_support.h"
#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {

// A box of sides 2, 4 and 6 about the origin, white and matt, as OBJ.
inline const std::string box_text = [] {
  std::string text = "mtllib m.mtl\nusemtl white\n";
  for (const char* x : {"-1", "1"})
    for (const char* y : {" -2", " 2"})
      for (const char* z : {" -3", " 3"}) text += std::string("v ") + x + y + z + "\n";
  return text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
}();
inline const NamedTexts box_files{{"box.obj", box_text},
                                  {"m.mtl", "newmtl white\nKd 1 1 1\nKs 0 0 0\nillum 1\n"}};

// Few pixels and samples, so that it is quick.
inline const std::string quick = "&width=40&height=30&samples=4";

class Stills : public testing::Test {
 protected:
  Stills() : id_(text_at(parse_json(kept().body), "id")) {}

  Response kept() { return own_.post("/models", form_of_files(box_files), form_type); }
  Response still(const std::string& query) { return own_.get("/still?model=" + id_ + query); }
  Response sent(const std::string& query) {
    return own_.post("/still?" + query, form_of_files(box_files), form_type);
  }
  std::string scene(const std::string& query) {
    const Response told = still("&as=scene" + query);
    EXPECT_EQ(told.status, 200) << told.body;
    EXPECT_EQ(told.content_type, "application/json");
    return told.body;
  }
  Png png(const std::string& query) {
    const Response picture = still(query);
    EXPECT_EQ(picture.status, 200) << picture.body;
    return read_png(picture.body);
  }

  Host own_;
  const std::string id_;
};

}  // namespace tia::test
