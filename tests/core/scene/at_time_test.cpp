// A scene at a time is the plain scene with the values of that time.
#include "core/scene/at_time.h"

#include <gtest/gtest.h>

#include "core/math/deterministic.h"
#include "tests/core/support.h"

namespace tia {
namespace {

// A scene of these members with these tracks.
Scene moving_scene(const std::string& tracks, const std::string& members) {
  return read_scene(R"({"animation":{"duration":4,"tracks":[)" + tracks + "]}," + members + "}");
}
// What it is at that time, as text.
std::string text_at_time(const std::string& tracks, const std::string& members, double seconds) {
  const Scene scene = moving_scene(tracks, members);
  return canonical_text(at_time(scene, seconds, middles_of(scene)));
}
std::string plain_text(const std::string& members) {
  return canonical_text(read_scene("{" + members + "}"));
}

const std::string two_balls =
    R"("objects":[{"name":"a","type":"sphere","center":[0,0,-9],"radius":2},
                  {"name":"b","type":"sphere","center":[1,0,-9],"radius":2,
                   "transform":[{"translate":[0,0,0]},{"rotate_degrees":[0,0,0]}],
                   "material":{"color":[1,0,0]}}])";

TEST(AtTime, WithoutTracksIsTheSceneWithoutItsAnimation) {
  EXPECT_EQ(text_at_time("", two_balls, 3), plain_text(two_balls));
}

TEST(AtTime, PutsValuesWhereTheTargetsPoint) {
  const std::string tracks =
      R"({"target":"/objects/b/transform/1/rotate_degrees","formula":["0","72*t","0"]},
         {"target":"/objects/1/transform/0/translate/2","keys":[[0,0],[4,8]]},
         {"target":"/objects/b/material/color","keys":[[0,[1,0,0]],[2,[0,0,1]]]},
         {"target":"/objects/a/radius","keys":[[0,2],[2,3]]},
         {"target":"/background","keys":[[0,0],[4,1]]})";
  const std::string plain =
      R"("background":0.25,"objects":[
          {"name":"a","type":"sphere","center":[0,0,-9],"radius":2.5},
          {"name":"b","type":"sphere","center":[1,0,-9],"radius":2,
           "transform":[{"translate":[0,0,2]},{"rotate_degrees":[0,72,0]}],
           "material":{"color":[0.5,0,0.5]}}])";
  EXPECT_EQ(text_at_time(tracks, two_balls, 1), plain_text(plain));
}

TEST(AtTime, PutsWhatIsNotWritten) {
  const std::string tracks =
      R"({"target":"/camera/fov_degrees","keys":[[0,20],[4,60]]},
         {"target":"/fog/density","keys":[[0,0.5],[4,0.1]]},
         {"target":"/objects/a/material/color","formula":["t/4","0","0"]},
         {"target":"/title","keys":[[0,"before"],[1,"after"]],"interpolation":"step"})";
  EXPECT_EQ(text_at_time(tracks, two_balls, 2),
            plain_text(R"("title":"after","camera":{"fov_degrees":40},"fog":{"density":0.3},
                "objects":[{"name":"a","type":"sphere","center":[0,0,-9],"radius":2,
                            "material":{"color":[0.5,0,0]}},)" +
                       two_balls.substr(two_balls.find(R"({"name":"b")"))));
}

TEST(AtTime, MovesParametersAndStepsThroughMaterialsByName) {
  const std::string members =
      R"("materials":{"red":{"color":[1,0,0]},"blue":{"color":[0,0,1]}},"objects":[
          {"type":"implicit","f":"x^2+y^2+z^2-r","parameters":{"r":1},"material":"red",
           "bounds":{"center":[0,0,0],"radius":3}}])";
  const std::string tracks =
      R"({"target":"/objects/0/parameters/r","formula":"1+t"},
         {"target":"/objects/0/material","keys":[[0,"red"],[1,"blue"]],"interpolation":"step"})";
  std::string plain = members;
  plain.replace(plain.find(R"("r":1)"), 5, R"("r":3)");
  plain.replace(plain.find(R"("material":"red")"), 16, R"("material":"blue")");
  EXPECT_EQ(text_at_time(tracks, members, 2), plain_text(plain));
}

TEST(AtTime, LightsTheKeyLightAsTheParameterDoes) {
  const std::string track = R"({"target":"/key_light/position","formula":["t","5","0"]})";
  for (const std::string members :
       {R"("key_light":{"type":"sphere","radius":3})", R"("lights":[])",
        R"("lights":[{"type":"sky"},{"type":"directional","direction":[0,-1,0]}])",
        R"("lights":[{"type":"point","position":[9,9,9]}])"}) {
    const std::string lit = std::string(members).append(",").append(two_balls);
    const Scene plain = read_scene(std::string("{").append(lit).append("}"));
    EXPECT_EQ(text_at_time(track, lit, 2), canonical_text(with_light(plain, {2, 5, 0}))) << members;
  }
}

TEST(AtTime, LeavesOutWhatIsNotVisible) {
  const std::string ball_b = two_balls.substr(two_balls.find(R"({"name":"b")"));
  const std::string members = two_balls + R"(,"lights":[{"type":"point","position":[0,9,0]}])";
  const std::string tracks =
      R"x({"target":"/objects/a","visible":[[0,1],[3,4]]},{"target":"/lights/0","visible":[[0,2]]},
         {"target":"/objects/a/radius","formula":"2 + 0/(1-floor(t))"})x";
  EXPECT_EQ(text_at_time(tracks, members, 0.5), plain_text(members));
  const std::string light = R"("lights":[{"type":"point","position":[0,9,0]}],)";
  EXPECT_EQ(text_at_time(tracks, members, 1), plain_text(light + R"("objects":[)" + ball_b));
  EXPECT_EQ(text_at_time(tracks, members, 2), plain_text(R"("objects":[)" + ball_b));
  EXPECT_EQ(text_at_time(tracks, members, 3.5), plain_text(two_balls));
}

TEST(AtTime, DoesNotDependOnTheOrderOfTheTracks) {
  const std::string one = R"({"target":"/objects/a","visible":[[2,3]]})";
  const std::string two = R"({"target":"/objects/b/radius","formula":"t+1"})";
  const std::string three = R"({"target":"/objects/b/center/0","keys":[[0,1],[4,3]]})";
  const std::string text = text_at_time(one + "," + two + "," + three, two_balls, 1);
  EXPECT_EQ(text_at_time(three + "," + two + "," + one, two_balls, 1), text);
}

// What does not move is not copied: a film of a moved light has one list of objects.
TEST(AtTime, SharesTheObjectsThatDoNotMove) {
  const Scene scene = moving_scene(R"({"target":"/background","formula":"t"})", two_balls);
  const Scene plain = at_time(scene, 0.5, {});
  EXPECT_EQ(&plain.objects.get(), &scene.objects.get());
  EXPECT_FALSE(moves_objects(*scene.animation));
  EXPECT_TRUE(moves_objects(
      *moving_scene(R"({"target":"/objects/a/radius","formula":"1+t"})", two_balls).animation));
}

TEST(AtTime, AnimationsReadBackAsTheyWereWritten) {
  const std::string text =
      R"({"animation":{"duration":5,"fps":30,"tracks":[)"
      R"({"keys":[[0,[1,2,3],"in_out"],[1.5,[4,5,6]]],"repeat":"loop","target":"/background"},)"
      R"({"interpolation":"bezier","keys":[[0,1,2,3]],"target":"/options/exposure"},)"
      R"({"formula":["a*t","0"],"parameters":{"a":2},"target":"/x"},)"
      R"({"formula":"t","target":"/y"},{"target":"/objects/0","visible":[[1,2]]}]}})";
  EXPECT_EQ(canonical_text(read_scene(text)), text);
}

TEST(AtTime, HasAsManyFramesAsBeginBeforeTheEnd) {
  const auto frames = [](double duration, double fps) {
    return Animation{duration, fps, 0, {}}.frames();
  };
  EXPECT_EQ(frames(5, 24), 120);
  EXPECT_EQ(frames(1, 0.5), 1);
  EXPECT_EQ(frames(1.01, 10), 11);
}

// ---- pictures -------------------------------------------------------------------------------

const std::string from_above =
    R"("options":{"integrator":"whitted"},
       "camera":{"projection":"orthographic","height":4,"location":[0,10,0],
                 "direction":[0,-1,0],"up":[0,0,-1]})";

// Lambert's law: a light over the origin of a white floor, at the angle pi t above the horizon,
// gives sin(pi t) there.
TEST(AtTime, ALightOverAHalfTurnShadesByLambertsCosine) {
  const Scene scene = moving_scene(
      R"x({"target":"/key_light/position","formula":["7*cos(pi*t)","7*sin(pi*t)","0"]})x",
      from_above + R"(,"objects":[{"type":"plane","point":[0,0,0],"normal":[0,1,0]}])");
  for (int i = 1; i < 16; ++i) {
    const double t = i / 16.0;
    const Image image = test::picture(at_time(scene, t, {}), 1, 1).image;
    EXPECT_NEAR(image.at(0, 0)[0], sin_of(pi * t), 1e-6) << t;
  }
}

// A pixel of the floor is dark where the line from it to the light passes the ball's middle at
// less than its radius; the shadow is around where the line from the light through the middle ends.
TEST(AtTime, TheShadowOfABallGoesAroundWithALightOnACircle) {
  const double ball = 0.25, height = 1, of_light = 4, away = 3;
  const Scene scene = moving_scene(
      R"x({"target":"/key_light/position","parameters":{"a":3},
          "formula":["a*cos(pi*t/2)","4","a*sin(pi*t/2)"]})x",
      from_above + R"(,"objects":[{"type":"plane","point":[0,0,0],"normal":[0,1,0]},
          {"type":"sphere","center":[0,1,0],"radius":0.25}])");
  constexpr int size = 64;
  for (int frame = 0; frame < 8; ++frame) {
    const double t = frame / 2.0;
    const Vec3d light{away * cos_of(pi * t / 2), of_light, away * sin_of(pi * t / 2)};
    const Vec3d middle{0, height, 0};
    const Image image = test::picture(at_time(scene, t, {}), size, size).image;
    Vec3d sum{};
    int dark = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const Vec3d p{((x + 0.5) / size - 0.5) * 4, 0, ((y + 0.5) / size - 0.5) * 4};
        if (length(p) < ball + 1e-3) continue;  // the eye sees the ball
        const double past = length(cross(middle - p, normalize(light - p)));
        if (std::fabs(past - ball) < 1e-3) continue;
        EXPECT_EQ(*image.at(x, y) == 0, past < ball) << x << " " << y << " at " << t;
        if (past < ball) sum = sum + p, ++dark;
      }
    ASSERT_GT(dark, 20);
    const Vec3d ends = light + (middle - light) * (of_light / (of_light - height));
    EXPECT_LT(length(sum * (1.0 / dark) - ends), 0.06);
  }
}

}  // namespace
}  // namespace tia
