// Rigid bodies against mechanics' closed forms. Source of all: Goldstein, Poole, Safko, "Classical
// Mechanics" (3rd edition, 2002), chapter 5; friction is Coulomb's.
#include "core/motion/rigid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/motion/simulate.h"
#include "core/scene/at_time.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

constexpr std::size_t most_steps = 1'000'000;
constexpr double pull = 9.81;
const std::string ground = R"({"name":"ground","type":"plane","point":[0,0,0],"normal":[0,1,0]})";

// A scene of one body on the ground, where gravity pulls as on an incline of that angle along x.
std::string on_incline(double degrees, const std::string& object, const std::string& body,
                       double duration, const std::string& floor = ground) {
  const double angle = degrees * pi / 180;
  return R"({"objects":[)" + floor + "," + object + R"(],"physics":{"solver":"rigid","duration":)" +
         std::to_string(duration) + R"(,"gravity":[)" + std::to_string(pull * std::sin(angle)) +
         "," + std::to_string(-pull * std::cos(angle)) +
         R"(,0],"bodies":[{"object":"body","mass":2,)" + body +
         R"(}],"fixed":[{"object":"ground"}]}})";
}
Scene motion_of(const std::string& text) {
  const Scene scene = read_scene(text);
  return with_motion(scene, simulate(scene, most_steps));
}
// What the transform of the second object makes of a point at a time.
Vec3d moved(const Scene& baked, double time, const Vec3d& p) {
  return at_time(baked, time, {}).objects[1].transform.affine().point(p);
}

// With its middle of mass above the edge where tan(angle) = width / height, whatever its section
// is. (Elastic, it would bounce off the ground and stand up again.)
TEST(Rigid, ABoxTopplesBeyondTheAngleWhoseTangentIsWidthOverHeight) {
  const double critical = std::atan(0.5) * 180 / pi;
  const std::array<std::string, 3> bodies{
      R"("type":"box","min":[-0.5,0,-0.5],"max":[0.5,2,0.5]})",
      R"("type":"cylinder","base":[0,0,0],"cap":[0,2,0],"radius":0.5})",
      R"("type":"mesh","positions":[-0.5,0,-0.5,0.5,0,-0.5,0.5,0,0.5,-0.5,0,0.5,
          -0.5,2,-0.5,0.5,2,-0.5,0.5,2,0.5,-0.5,2,0.5],"indices":[0,1,2,0,2,3,4,6,5,4,7,6,
          0,5,1,0,4,5,1,6,2,1,5,6,2,7,3,2,6,7,3,4,0,3,7,4]})"};
  for (const std::string& shape : bodies) {
    for (const double beyond : {-1.0, 1.0}) {
      const std::string body = R"({"name":"body",)" + shape;
      const Scene baked =
          motion_of(on_incline(critical + beyond, body, R"("friction":2,"restitution":0)", 3));
      const Vec3d up = moved(baked, 3, {0, 2, 0}) - moved(baked, 3, {0, 0, 0});
      if (beyond < 0) EXPECT_GT(up.y, 1.99) << shape;
      else EXPECT_LT(up.y, 1) << shape;
    }
  }
}

TEST(Rigid, ABallRollsWithoutSlippingAtFiveSeventhsOfTheSlide) {
  for (const double radius : {0.5, 0.02, 20.0}) {
    const std::string r = std::to_string(radius);
    const std::string ball =
        R"({"name":"body","type":"sphere","center":[0,)" + r + R"(,0],"radius":)" + r + "}";
    const Scene baked = motion_of(on_incline(20, ball, R"("friction":1)", 2));
    const double way = 5.0 / 7 * pull * std::sin(20 * pi / 180) * 2 * 2 / 2;
    const Vec3d middle = moved(baked, 2, {0, radius, 0});
    EXPECT_NEAR(middle.x, way, 0.02 * way) << radius;
    EXPECT_NEAR(middle.y, radius, 0.02 * radius) << radius;
    // It has turned by its way over its radius, so the top's speed is twice the middle's.
    const double dt = 1e-3;
    const Vec3d before = moved(baked, 1 - dt, {0, radius, 0}),
                after = moved(baked, 1 + dt, {0, radius, 0});
    const Affine place = at_time(baked, 1, {}).objects[1].transform.affine();
    const Vec3d now = place.point(Vec3d{0, radius, 0});
    const Vec3d low = place.inverse().point(now - Vec3d{0, radius, 0});  // which touches the ground
    const double slip = (moved(baked, 1 + dt, low).x - moved(baked, 1 - dt, low).x) / (2 * dt);
    EXPECT_NEAR(slip, 0, 0.02 * (after.x - before.x) / (2 * dt)) << radius;
  }
}

TEST(Rigid, FrictionStopsAtTheSquareOfTheSpeedOverTwiceItsPull) {
  const double v = 3, mu = 0.25;
  const std::string box = R"({"name":"body","type":"box","min":[-0.5,0,-0.5],"max":[0.5,0.5,0.5]})";
  const std::string body =
      R"("velocity":[3,0,0],"restitution":0,"friction":0.125)";  // the ground's is 0.5
  const Scene baked = motion_of(on_incline(0, box, body, 2.5));
  const double way = v * v / (2 * mu * pull);
  EXPECT_NEAR(moved(baked, 2.5, {}).x, way, 0.02 * way);
  EXPECT_NEAR(moved(baked, 2, {}).x, moved(baked, 2.5, {}).x, 0.001 * way);
}

// A ball that falls by h comes back up to e^2 h, which it reaches (1 + e) sqrt(2 h / g) after it
// was let go, whatever its size is.
TEST(Rigid, ABallBouncesToTheSquareOfItsRestitution) {
  test::Random random(1);
  for (const double radius : {0.05, 0.5, 1.0, 3.0}) {
    for (const double e : {0.0, 0.3, 0.8, 1.0}) {
      const double h = radius * random.in(2, 5), time = std::sqrt(2 * h / pull) * (1 + e);
      const std::string r = std::to_string(radius), y = std::to_string(radius + h);
      const std::string ball =
          R"({"name":"body","type":"sphere","center":[0,)" + y + R"(,0],"radius":)" + r + "}";
      const std::string bounce = R"("restitution":)" + std::to_string(e);
      const Scene baked = motion_of(on_incline(0, ball, bounce, time));
      EXPECT_NEAR(moved(baked, time, {0, radius + h, 0}).y - radius, e * e * h, 0.03 * h)
          << radius << ", " << e;
    }
  }
}

// A cylinder has half m r^2 about its axis: it rolls at g sin / (1 + 1/2). A ball on too little
// friction, mu < 2/7 tan, slides at g (sin - mu cos).
TEST(Rigid, ACylinderRollsAtTwoThirdsAndABallSlidesWhereFrictionIsLow) {
  const double angle = 25 * pi / 180, t = 1.5;
  const std::string cylinder =
      R"({"name":"body","type":"cylinder","base":[0,0.5,-0.7],"cap":[0,0.5,0.7],"radius":0.5})";
  const Scene rolls = motion_of(on_incline(25, cylinder, R"("friction":1,"restitution":0)", t));
  const double two_thirds = pull * std::sin(angle) * t * t / 3;
  EXPECT_NEAR(moved(rolls, t, {0, 0.5, 0}).x, two_thirds, 0.02 * two_thirds);
  const std::string ball = R"({"name":"body","type":"sphere","center":[0,0.5,0],"radius":0.5})";
  const Scene slides = motion_of(on_incline(25, ball, R"("friction":0.02,"restitution":0)", t));
  const double mu = 0.1;  // the geometric mean with the ground's 0.5
  const double way = pull * (std::sin(angle) - mu * std::cos(angle)) * t * t / 2;
  EXPECT_NEAR(moved(slides, t, {0, 0.5, 0}).x, way, 0.02 * way);
}

// A ball that slides at v without spin is slowed by mu g and turned by 5 mu g / (2 r), until it
// rolls: at 5/7 v, after 2 v / (7 mu g), having come 12 v^2 / (49 mu g).
TEST(Rigid, ASlidingBallComesToRollAtFiveSevenths) {
  const double v = 4, mu = 0.3, t = 2;
  const std::string ball = R"({"name":"body","type":"sphere","center":[0,0.5,0],"radius":0.5})";
  const Scene baked =
      motion_of(on_incline(0, ball, R"("velocity":[4,0,0],"restitution":0,"friction":0.18)", t));
  const double rolls = 2 * v / (7 * mu * pull);
  const double way = 12 * v * v / (49 * mu * pull) + 5.0 / 7 * v * (t - rolls);
  EXPECT_NEAR(moved(baked, t, {0, 0.5, 0}).x, way, 0.01 * way);
}

TEST(Rigid, ASpinGoesOnAboutTheCentreOfMass) {
  const Scene baked =
      motion_of(R"({"objects":[{"name":"other","type":"sphere","center":[0,50,0],"radius":1},
      {"name":"body","type":"box","min":[2,1,0],"max":[3,2,1]}],
    "physics":{"solver":"rigid","gravity":[0,0,0],"duration":2,"bodies":[
        {"object":"body","mass":3,"spin":[0,2,0],"velocity":[0,0,0.5]}]}})");
  for (const double t : {0.0, 0.7, 1.4, 2.0}) {
    const double angle = 2 * t;  // a corner, from the middle (2.5, 1.5, 0.5)
    const Vec3d from{0.5, 0.5, 0.5};
    const Vec3d turned{from.x * std::cos(angle) + from.z * std::sin(angle), from.y,
                       from.z * std::cos(angle) - from.x * std::sin(angle)};
    const Vec3d expected = Vec3d{2.5, 1.5, 0.5 + 0.5 * t} + turned;
    EXPECT_NEAR(length(moved(baked, t, {3, 2, 1}) - expected), 0, 1e-3) << t;
  }
}

TEST(Rigid, EveryKindOfBodyComesToRestOnEveryKindOfGround) {
  const std::vector<std::pair<std::string, double>> bodies = {
      // and how high its middle lies
      {R"("type":"sphere","center":[0,1.5,0],"radius":0.5)", 0.5},
      {R"("type":"box","min":[-0.5,1,-0.5],"max":[0.5,2,0.5])", 0.5},
      {R"("type":"cylinder","base":[0,1,0],"cap":[0,2,0],"radius":0.5)", 0.5},
      {R"("type":"cone","base":[0,1,0],"cap":[0,2,0],"base_radius":0.5)", 0.25},
      {R"("type":"cone","base":[0,1,0],"cap":[0,2,0],"base_radius":0.5,"cap_radius":0.4)", 0.4631},
      {R"("type":"capsule","base":[-0.5,1.5,0],"cap":[0.5,1.5,0],"radius":0.5)", 0.5},
      {R"("type":"mesh","positions":[-0.5,1,-0.5,0.5,1,-0.5,0,1,0.5,0,2,0],
          "indices":[0,1,2,0,3,1,1,3,2,2,3,0])",
       0.25}};
  const std::vector<std::string> grounds = {
      ground, R"({"name":"ground","type":"box","min":[-9,-1,-9],"max":[9,0,9]})",
      R"({"name":"ground","type":"mesh","positions":[-9,0,-9,9,0,-9,9,0,9,-9,0,9],
          "indices":[0,2,1,0,3,2]})"};
  for (const auto& [body, height] : bodies)
    for (const std::string& floor : grounds) {
      SCOPED_TRACE(body + floor);
      const Scene scene = read_scene(
          on_incline(0, R"({"name":"body",)" + body + "}", R"("restitution":0)", 2, floor));
      const Simulation made = simulate(scene, most_steps);
      ASSERT_FALSE(made.energy.empty());
      // m g h above the ground, and at rest.
      EXPECT_NEAR(made.energy.back().potential / (2 * pull), height, 0.01);
      EXPECT_NEAR(made.energy.back().kinetic, 0, 0.01);
      ASSERT_FALSE(made.contacts.empty());
      EXPECT_EQ(made.contacts[0].a, "body");
      EXPECT_EQ(made.contacts[0].b, "ground");
      EXPECT_GT(made.contacts[0].normal.y, 0.99);
    }
}

TEST(Rigid, AFastBallDoesNotPassAThinWall) {
  const Scene baked = motion_of(R"({"objects":[
      {"name":"wall","type":"box","min":[5,-5,-5],"max":[5.001,5,5]},
      {"name":"body","type":"sphere","center":[0,0,0],"radius":0.1}],
    "physics":{"solver":"rigid","gravity":[0,0,0],"duration":0.5,"bodies":[
        {"object":"body","mass":1,"velocity":[1000,0,0]}],"fixed":[{"object":"wall"}]}})");
  EXPECT_LT(moved(baked, 0.5, {}).x, 5);
}

TEST(Rigid, SimulatedAgainItIsTheSame) {
  std::string objects = ground, bodies;
  for (int i = 0; i < 12; ++i) {
    const std::string name = "b" + std::to_string(i), y = std::to_string(1.1 * i);
    objects += R"(,{"name":")" + name + R"(","type":"box","min":[)" +
               std::to_string(0.1 * (i % 3)) + "," + y + R"(,0],"max":[1,)" +
               std::to_string(1.1 * i + 1) + ",1]}";
    bodies += (i > 0 ? "," : "") + (R"({"object":")" + name) + R"(","density":1})";
  }
  const Scene scene = read_scene(R"({"objects":[)" + objects + R"(],"physics":{"solver":"rigid",
      "duration":1,"bodies":[)" + bodies +
                                 R"(],"fixed":[{"object":"ground"}]}})");
  const auto text = [&] { return canonical_text(with_motion(scene, simulate(scene, most_steps))); };
  EXPECT_TRUE(text() == text());
}

TEST(Rigid, FaultsNameBodies) {
  const auto refused = [](const std::string& object, const std::string& body, std::size_t most,
                          const test::Expected& expected) {
    const Scene scene = read_scene(on_incline(0, object, body, 2));
    test::expect_faults(test::faults_of([&] { simulate(scene, most); }), {expected});
  };
  const std::string at = "/physics/bodies/0/object";
  refused(R"({"name":"body","type":"torus","major_radius":2,"minor_radius":1})", R"("friction":1)",
          most_steps, {FaultKind::conflict, at, "\"body\"", "by rigid a sphere, box"});
  refused(R"({"name":"body","type":"sphere","center":[0,0.5,0],"radius":1})", R"("friction":1)",
          most_steps, {FaultKind::conflict, at, "\"body\"", "at 0 s it is in ground"});
  refused(R"({"name":"body","type":"sphere","center":[0,1,0],"radius":1})", R"("friction":1)", 479,
          {FaultKind::limit, "/physics/duration", "2", "at most 479 steps of all bodies"});
}

}  // namespace
}  // namespace tia
