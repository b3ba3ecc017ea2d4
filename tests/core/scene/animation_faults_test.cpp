// What may be wrong with an animation: as it is read, and at a time.
#include <gtest/gtest.h>

#include "core/scene/animation_check.h"
#include "core/scene/at_time.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using enum FaultKind;
using test::expect_faults;
using test::Expected;

std::string moving(const std::string& tracks, const std::string& more = "") {
  return R"({"animation":{"duration":2,"tracks":[)" + tracks + "]}" + more + "}";
}
const std::string with_ball =
    R"(,"objects":[{"name":"ball","type":"sphere","center":[0,0,-9],"radius":2},
                   {"name":"twin","type":"sphere","center":[0,0,-9],"radius":2},
                   {"name":"twin","type":"box","min":[0,0,0],"max":[1,1,1]}])";
void expect_track_refused(const std::string& track, const std::vector<Expected>& expected) {
  test::expect_scene_refused(moving(track), expected);
}
void expect_refused_at(double seconds, const std::string& tracks,
                       const std::vector<Expected>& expected) {
  SCOPED_TRACE(tracks);
  const Scene scene = read_scene(moving(tracks, with_ball));
  expect_faults(test::faults_of([&] { at_time(scene, seconds, {}); }), expected);
}

TEST(AnimationFaults, OfTheWhole) {
  test::expect_scene_refused(R"({"animation":{}})", {{missing, "/animation/duration", "", ""}});
  test::expect_scene_refused(R"({"animation":{"duration":0}})",
                             {{out_of_range, "/animation/duration", "0", "above 0"}});
  test::expect_scene_refused(R"({"animation":{"duration":2000,"fps":60}})",
                             {{limit, "/animation/duration", "2000", "100000 frames"}});
  test::expect_scene_refused(R"({"animation":{"duration":1,"shutter":1.5}})",
                             {{out_of_range, "/animation/shutter", "1.5", "from 0 to 1"}});
  test::expect_scene_refused(R"({"animation":{"duration":1,"shuter":0.5}})",
                             {{unknown_name, "/animation/shuter", "\"shuter\"",
                               "duration, fps, shutter, tracks", "shutter"}});
}

TEST(AnimationFaults, OfTracks) {
  const std::string at = "/animation/tracks/0";
  expect_track_refused(R"({"target":"/background"})", {{missing, at, "", "keys, formula"}});
  expect_track_refused(R"({"target":"/background","keys":[[0,1]],"formula":"t"})",
                       {{conflict, at, "", "one of keys, formula"}});
  expect_track_refused(R"({"target":"/background","formula":"t","repeat":"loop"})",
                       {{conflict, at + "/repeat", "", "with keys"}});
  expect_track_refused(R"({"target":"/background","keys":[]})",
                       {{wrong_type, at + "/keys", "[]", "at least 1"}});
  expect_track_refused(R"({"target":"/background","keys":[[0,1],[1,2],[1,3]]})",
                       {{out_of_range, at + "/keys/2/0", "1", "ascend"}});
  expect_track_refused(R"({"target":"/background","keys":[[0,[1,2,3]],[1,2]]})",
                       {{conflict, at + "/keys/1/1", "2", "as many numbers"}});
  expect_track_refused(R"({"target":"/background","keys":[[0,"red"]]})",
                       {{wrong_type, at + "/keys/0/1", "\"red\"", "interpolation step"}});
  expect_track_refused(R"({"target":"/background","keys":[[0,1,0,0]]})",
                       {{conflict, at + "/keys/0", "", "tangents by bezier"}});
  expect_track_refused(R"({"target":"/background","keys":[[0,1]],"interpolation":"bezier"})",
                       {{conflict, at + "/keys/0", "", "with tangents"}});
  expect_track_refused(R"({"target":"/background","keys":[[0,1,"inn"]]})",
                       {{unknown_name, at + "/keys/0/2", "\"inn\"", "none, in, out", "in"}});
  expect_track_refused(R"({"target":"/background","keys":[[0]]})",
                       {{wrong_type, at + "/keys/0", "[0]", "[t, value]"}});
  expect_track_refused(R"({"target":"/background","formula":["t","s"]})",
                       {{unknown_name, at + "/formula/1", "\"s\"", "t, pi"}});
  expect_track_refused(R"({"target":"/background","formula":"t","parameters":{"t":1}})",
                       {{out_of_range, at + "/parameters/t", "\"t\"", "means nothing else"}});
  expect_track_refused(R"({"target":"/objects/0","visible":[[2,1]]})",
                       {{out_of_range, at + "/visible/0", "[2,1]", "later"}});
}

TEST(AnimationFaults, OfTargetsThatAreNotThere) {
  const std::string at = "/animation/tracks/0/target";
  const auto keyed = [](const std::string& target) {
    return R"({"target":")" + target + R"(","keys":[[0,1]]})";
  };
  expect_refused_at(0, keyed("/objects/9/radius"), {{unknown_name, at, "\"9\"", "0 to 2"}});
  expect_refused_at(0, keyed("/objects/bal/radius"),
                    {{unknown_name, at, "\"bal\"", "ball, twin", "ball"}});
  expect_refused_at(0, keyed("/objects/twin/radius"), {{conflict, at, "\"twin\"", "one element"}});
  expect_refused_at(0, keyed("/objects/ball/radius/x"),
                    {{unknown_name, at, "\"/objects/0/radius/x\"", "no parts"}});
  expect_refused_at(0, keyed("/objects/ball/radus"),
                    {{unknown_name, at, "\"radus\"", "at 0 s at /objects/0/radus", "radius"}});
  expect_refused_at(0, keyed("/object/ball"),
                    {{unknown_name, at, "\"/object/ball\"", "camera, background", "objects"}});
  expect_refused_at(0, keyed("background"),
                    {{unknown_name, at, "\"background\"", "JSON Pointer", "background"}});
  expect_refused_at(0, keyed("/animation/duration"),
                    {{unknown_name, at, "\"/animation/duration\"", "camera, background"}});
  expect_refused_at(0, keyed("/camera/location/0"),
                    {{missing, at, "", "whole of /camera/location"}});
  expect_refused_at(0, R"({"target":"/camera","visible":[[0,1]]})",
                    {{out_of_range, at, "\"/camera\"", "an object or a light"}});
}

TEST(AnimationFaults, OfTargetsThatAreHitTwiceOrInOneAnother) {
  const std::string later = "/animation/tracks/1/target";
  const auto both = [](const std::string& a, const std::string& b) {
    return R"({"target":")" + a + R"(","formula":"1"},{"target":")" + b + R"(","formula":"1"})";
  };
  expect_refused_at(0, both("/objects/0/radius", "/objects/ball/radius"),
                    {{conflict, later, "\"/objects/ball/radius\"", "track 0 moves"}});
  expect_refused_at(0, both("/objects/0/center/1", "/objects/0/center"),
                    {{conflict, later, "\"/objects/0/center\"", "around it or in it"}});
  expect_refused_at(0, both("/key_light/position", "/key_light"),
                    {{conflict, later, "\"/key_light\"", "track 0"}});
}

TEST(AnimationFaults, OfValuesAtATimeSayWhichAndWhen) {
  expect_refused_at(1.5, R"({"target":"/objects/ball/radius","formula":"1-t"})",
                    {{out_of_range, "/animation/tracks/0", "-0.5",
                      "at 1.5 s at /objects/0/radius: a number above 0"}});
  expect_refused_at(1.2, R"x({"target":"/objects/ball/radius","formula":"sqrt(1-t)"})x",
                    {{out_of_range, "/animation/tracks/0/formula", "\"sqrt(1-t)\"",
                      "at 1.2 s a finite number for /objects/ball/radius"}});
  expect_refused_at(0, R"({"target":"/objects/ball/radius","formula":["1","2"]})",
                    {{wrong_type, "/animation/tracks/0", "[1,2]", "/objects/0/radius: a number"}});
  expect_refused_at(0, R"({"target":"/key_light/position","formula":"1"})",
                    {{wrong_type, "/animation/tracks/0", "1", "3 numbers"}});
}

// Those of all tracks come at once; numbers are those of the scene as it is written, though an
// object before is not there.
TEST(AnimationFaults, ComeAtOnceAndNameTheTrackWhateverIsNotThere) {
  expect_refused_at(
      1,
      R"x({"target":"/objects/0","visible":[[0,1]]},
                       {"target":"/objects/1/radius","formula":"-t"},
                       {"target":"/objects/2/colour","formula":"1"},
                       {"target":"/lights/4/color","formula":"1"},
                       {"target":"/background","formula":"log(0*t)"})x",
      {{missing, "/animation/tracks/3/target", "", ""},
       {out_of_range, "/animation/tracks/4/formula", "\"log(0*t)\"", "/background"},
       {out_of_range, "/animation/tracks/1", "-1", "at /objects/1/radius"},
       {unknown_name, "/animation/tracks/2/target", "\"colour\"", "at /objects/2/colour"}});
}

TEST(AnimationFaults, AreThoseOfTheTimeThatIsAskedFor) {
  const Scene scene =
      read_scene(moving(R"({"target":"/objects/ball/radius","formula":"1-t"})", with_ball));
  EXPECT_NO_THROW(at_time(scene, 0.5, {}));
  EXPECT_THROW(at_time(scene, 1, {}), InputError);
}

// The first moment at which each track has one: a frame's, a key's own, or an interval's end.
TEST(AnimationFaults, AreFoundAtEveryMomentOfAnAnimationAllTracksAtOnce) {
  const std::string tracks =
      R"x({"target":"/objects/ball/radius","interpolation":"step","keys":[[0,1],[1.2,-1],[1.3,1]]},
          {"target":"/background","formula":"sqrt(1.25-t)"},
          {"target":"/camera/fov_degrees","keys":[[0,20],[1.41,20],[1.42,200],[1.43,20]]},
          {"target":"/objects/2/min/0","formula":"-t"})x";
  const std::string comes_and_goes = R"(,{"target":"/objects/2","visible":[[0,1]]})";
  for (const std::string& more : {std::string(), comes_and_goes}) {
    const Scene scene = read_scene(moving(tracks + more, with_ball));
    expect_faults(test::faults_of([&] { check_animation(scene); }),
                  {{out_of_range, "/animation/tracks/0", "-1", "at 1.2 s at /objects/0/radius"},
                   {out_of_range, "/animation/tracks/1/formula", "\"sqrt(1.25-t)\"",
                    "at 1.2916666666666667 s a finite number for /background"},
                   {out_of_range, "/animation/tracks/2", "200", "at 1.42 s at /camera/fov"}});
  }
}

}  // namespace
}  // namespace tia
