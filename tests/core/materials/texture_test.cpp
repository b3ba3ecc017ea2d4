// The patterns of space, against their closed forms.
#include "core/materials/texture.h"

#include "core/math/deterministic.h"
#include "tests/core/materials/textures.h"

namespace tia {
namespace {

using test::color_at;
using test::expect_color;
using test::Random;
using test::red_at;
using test::texture_form;

const Vec3d white_cell{1, 1, 1}, black_cell{0, 0, 0};

int parity(double x) { return static_cast<int>(std::floor(x)) & 1; }

// A share as red, from 0 to 1.
std::string ramp_json(const std::string& type, const std::string& more = "") {
  return R"({"type":")" + type + R"(","colors":[[0,0,1],[1,0,1]])" + more + "}";
}

// ---- checker, stripes -----------------------------------------------------------------------

TEST(Checker, IsTheParityOfItsCells) {
  Random random(310);
  const TextureForm form = texture_form(R"({"type":"checker","colors":[[1,0.5,0],[0,0.25,2]]})");
  for (int i = 0; i < 5000; ++i) {
    const Vec3d p = random.point(50);
    const bool odd = (parity(p.x) + parity(p.y) + parity(p.z)) % 2 == 1;
    EXPECT_EQ(color_at(form, p), odd ? (Vec3d{0, 0.25, 2}) : (Vec3d{1, 0.5, 0}));
  }
}

TEST(Checker, IsWhiteAtTheOriginAndBlackBesideIt) {
  const TextureForm form = texture_form(R"({"type":"checker"})");
  EXPECT_EQ(color_at(form, {0.5, 0.5, 0.5}), white_cell);
  for (const Vec3d& p :
       {Vec3d{1.5, 0.5, 0.5}, Vec3d{0.5, -0.5, 0.5}, Vec3d{0.5, 0.5, 1.5}, Vec3d{1.5, 1.5, -0.5}})
    EXPECT_EQ(color_at(form, p), black_cell);
  EXPECT_EQ(color_at(form, {1.5, 1.5, 0.5}), white_cell);
}

TEST(Checker, ScaleIsTheSizeOfACell) {
  const TextureForm form = texture_form(R"({"type":"checker","scale":2.5})");
  EXPECT_EQ(color_at(form, {2.4, 0.1, 0.1}), white_cell);
  EXPECT_EQ(color_at(form, {2.5, 0.1, 0.1}), black_cell);
  EXPECT_EQ(color_at(form, {4.9, 0.1, 0.1}), black_cell);
  EXPECT_EQ(color_at(form, {5, 0.1, 0.1}), white_cell);
}

// Each whole multiple of the scale, in double, begins a cell.
TEST(Checker, CellsBeginAtMultiplesOfTheScale) {
  const TextureForm form = texture_form(R"({"type":"stripes","scale":49})");
  for (int i = -100; i < 100; ++i)
    EXPECT_EQ(color_at(form, {49.0 * i, 0, 0}), i % 2 == 0 ? white_cell : black_cell) << i;
}

TEST(Checker, FarCellsKeepTheirParity) {
  const TextureForm form = texture_form(R"({"type":"checker","scale":0.5})");
  EXPECT_EQ(color_at(form, {1e9, 1e9, 1e9}), white_cell);
  EXPECT_EQ(color_at(form, {1e9 + 0.5, 1e9, 1e9}), black_cell);
  EXPECT_EQ(color_at(form, {1e9 + 0.5, 1e9, 1e9 + 0.5}), white_cell);
}

TEST(Stripes, LieAcrossX) {
  Random random(311);
  const TextureForm form = texture_form(R"({"type":"stripes","scale":0.25})");
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random.point(20);
    EXPECT_EQ(color_at(form, p), parity(p.x * 4) == 1 ? black_cell : white_cell);
  }
}

// The transform takes the pattern's points to the object's.
TEST(Stripes, AreMovedTurnedAndStretched) {
  const TextureForm moved =
      texture_form(R"({"type":"stripes","transform":[{"translate":[0.25,0,0]}]})");
  EXPECT_EQ(color_at(moved, {0.2, 0, 0}), black_cell);
  EXPECT_EQ(color_at(moved, {0.3, 0, 0}), white_cell);
  EXPECT_EQ(color_at(moved, {1.2, 0, 0}), white_cell);
  const TextureForm turned =
      texture_form(R"({"type":"stripes","transform":[{"rotate_degrees":[0,0,90]}]})");
  EXPECT_EQ(color_at(turned, {7.5, 0.5, 0}), white_cell);
  EXPECT_EQ(color_at(turned, {7.5, 1.5, 0}), black_cell);
  const TextureForm stretched =
      texture_form(R"({"type":"stripes","scale":2,"transform":[{"scale":[3,1,1]}]})");
  EXPECT_EQ(color_at(stretched, {5.9, 0, 0}), white_cell);
  EXPECT_EQ(color_at(stretched, {6.1, 0, 0}), black_cell);
}

// A pattern that is moved along with the points shows them the same.
TEST(Checker, TransformIsUndone) {
  Random random(312);
  const std::string steps =
      R"([{"scale":[2,0.5,-3]},{"rotate_degrees":[20,30,40]},{"translate":[4,5,6]}])";
  TransformSteps placement;
  Faults faults;
  read_value(parse_json(steps), Place{}, Spec{}, faults, placement);
  const TextureForm plain = texture_form(R"({"type":"checker","scale":0.7})");
  const TextureForm placed =
      texture_form(R"({"type":"checker","scale":0.7,"transform":)" + steps + "}");
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random.point(10);
    EXPECT_EQ(color_at(placed, placement.affine().point(p)), color_at(plain, p));
  }
}

// ---- points that lie a little off their surface -----------------------------------------------

// The plane y = 0 and others at the edges of cells, with points computed 4e-6 of their size off.
TEST(Blur, FlatSurfacesAtCellEdgesShowNoSpeckles) {
  Random random(313);
  const TextureForm form = texture_form(R"({"type":"checker","scale":2})");
  for (const double height : {0.0, 2.0, -6.0}) {
    const int layer = static_cast<int>(height / 2);
    for (int i = 0; i < 5000; ++i) {
      const Vec3d at = random.point(100);
      const double off = 4e-6 * 100;
      const Vec3d p{at.x, height + random.in(-off, off), at.z};
      if (std::fabs(std::remainder(p.x, 2.0)) < 2 * off) continue;  // at the edges of cells
      if (std::fabs(std::remainder(p.z, 2.0)) < 2 * off) continue;
      const bool odd = ((parity(p.x / 2) + parity(p.z / 2) + layer) & 1) == 1;
      ASSERT_EQ(color_at(form, p, off), odd ? black_cell : white_cell);
    }
  }
}

TEST(Blur, IsALengthInObjectSpaceWhateverTheTransform) {
  const double off = 1e-3;
  for (const char* more :
       {R"("scale":0.25)", R"("scale":64)", R"("transform":[{"scale":[0.01,5,7]}])",
        R"("scale":3,"transform":[{"rotate_degrees":[0,0,90]},{"scale":8}])"}) {
    const TextureForm form =
        texture_form(std::string(R"({"type":"stripes","colors":[0.5,0.25],)") + more + "}");
    for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}}) {
      EXPECT_EQ(red_at(form, axis * (0.99 * off), off), 0.5) << more;
      EXPECT_EQ(red_at(form, axis * (-0.99 * off), off), 0.5) << more;
    }
  }
  const TextureForm wide = texture_form(R"({"type":"stripes","scale":64})");
  EXPECT_EQ(color_at(wide, {-1.01 * off, 0, 0}, off), black_cell) << "not more than the length";
}

TEST(Blur, OfNothingChangesNothing) {
  const TextureForm form = texture_form(R"({"type":"stripes"})");
  EXPECT_EQ(color_at(form, {-1e-16, 0, 0}, 0), black_cell);
  EXPECT_EQ(color_at(form, {0, 0, 0}, 0), white_cell);
}

TEST(Blur, GradientsAndRingsBeginWhereSurfacesStand) {
  const double off = 1e-5;
  EXPECT_EQ(red_at(texture_form(ramp_json("gradient")), {3 - off / 2, 0, 0}, off), 0);
  EXPECT_NEAR(red_at(texture_form(ramp_json("gradient")), {3 - 2 * off, 0, 0}, off), 1 - 2 * off,
              1e-12);
  const TextureForm wood = texture_form(ramp_json("wood", R"(,"turbulence":0)"));
  for (int i = 0; i < 360; ++i) {  // a cylinder of radius 2
    const double angle = i, radius = 2 + (i % 2 == 0 ? off : -off) / 2;
    const Vec3d p{radius * std::cos(angle), 0.1 * i, radius * std::sin(angle)};
    EXPECT_NEAR(red_at(wood, p, off), 0, off) << i;
  }
}

// ---- gradient, stops ------------------------------------------------------------------------

TEST(Gradient, IsTheFractionOfX) {
  Random random(314);
  const TextureForm form = texture_form(ramp_json("gradient", R"(,"scale":2)"));
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random.point(50);
    expect_color(color_at(form, p), {p.x / 2 - std::floor(p.x / 2), 0, 1}, 1e-15);
  }
}

TEST(Gradient, StopsStandAtEvenDistancesWithLinesBetween) {
  const TextureForm form =
      texture_form(R"({"type":"gradient","colors":[[1,0,0],[0,1,0],[0,0,1],[1,1,1],[0,8,0]]})");
  EXPECT_EQ(color_at(form, {0, 0, 0}), (Vec3d{1, 0, 0}));
  EXPECT_EQ(color_at(form, {0.25, 0, 0}), (Vec3d{0, 1, 0}));
  EXPECT_EQ(color_at(form, {0.5, 0, 0}), (Vec3d{0, 0, 1}));
  EXPECT_EQ(color_at(form, {0.75, 0, 0}), (Vec3d{1, 1, 1}));
  EXPECT_EQ(color_at(form, {0.125, 0, 0}), (Vec3d{0.5, 0.5, 0}));
  EXPECT_EQ(color_at(form, {0.875, 0, 0}), (Vec3d{0.5, 4.5, 0.5}));
  expect_color(color_at(form, {std::nextafter(1.0, 0.0), 0, 0}), {0, 8, 0}, 1e-12);
}

TEST(Ramp, EndsAreHeldAndNanIsTheFirst) {
  const Ramp stops({Color{3, 0, 0}, Color{0, 5, 0}});
  EXPECT_EQ(stops.at(-1), (Vec3d{3, 0, 0}));
  EXPECT_EQ(stops.at(1), (Vec3d{0, 5, 0}));
  EXPECT_EQ(stops.at(7), (Vec3d{0, 5, 0}));
  EXPECT_EQ(stops.at(std::nan("")), (Vec3d{3, 0, 0}));
}

// ---- noise, marble, wood ----------------------------------------------------------------------

TEST(NoiseTexture, IsGradientNoiseInZeroToOne) {
  Random random(315);
  const TextureForm form = texture_form(ramp_json("noise", R"(,"scale":0.5)"));
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random.point(50);
    const double share = std::clamp((1 + gradient_noise(p * 2.0)) / 2, 0.0, 1.0);
    EXPECT_EQ(red_at(form, p), share);
  }
  EXPECT_EQ(red_at(form, {3.5, -2, 7}), 0.5);
}

TEST(MarbleTexture, WithoutTurbulenceIsACosine) {
  const TextureForm form = texture_form(ramp_json("marble", R"(,"turbulence":0)"));
  for (int i = -50; i < 50; ++i) {
    EXPECT_EQ(red_at(form, {1.0 * i, 0.3, i / 3.0}), 0);
    EXPECT_EQ(red_at(form, {i + 0.5, 0.3, i / 3.0}), 1);
    EXPECT_NEAR(red_at(form, {i + 0.25, 0.3, i / 3.0}), 0.5, 1e-15);
    EXPECT_NEAR(red_at(form, {i + 1 / 3.0, 0.3, 5}), 0.75, 1e-13);
  }
}

TEST(MarbleTexture, TurbulenceBendsTheVeins) {
  Random random(316);
  const TextureForm form = texture_form(ramp_json("marble", R"(,"turbulence":2.5)"));
  const TextureForm standard = texture_form(ramp_json("marble"));
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random.point(20);
    const auto share = [&](double turbulence) {
      return (1 - std::cos(2 * pi * (p.x + turbulence * turbulence_at(p)))) / 2;
    };
    EXPECT_NEAR(red_at(form, p), share(2.5), 1e-12);
    EXPECT_NEAR(red_at(standard, p), share(1), 1e-12);
  }
  EXPECT_EQ(red_at(form, {3, 4, 5}), 0) << "there is no turbulence at integers";
}

TEST(WoodTexture, RingsRunAroundTheYAxis) {
  Random random(317);
  const TextureForm round = texture_form(ramp_json("wood", R"(,"turbulence":0)"));
  const TextureForm bent = texture_form(ramp_json("wood", R"(,"turbulence":0.4)"));
  EXPECT_EQ(red_at(round, {0, 3, 0}), 0);
  EXPECT_EQ(red_at(round, {3, 17, 4}), 0) << "3-4-5";
  EXPECT_EQ(red_at(round, {0, 17, -2.5}), 0.5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random.point(20);
    const auto expect_ring = [&](const TextureForm& form, double turbulence) {
      const double ring = std::hypot(p.x, p.z) + turbulence * turbulence_at(p);
      EXPECT_NEAR(red_at(form, p), ring - std::floor(ring), 1e-13);
    };
    expect_ring(round, 0);
    expect_ring(bent, 0.4);
  }
}

TEST(Textures, GiveColoursBetweenTheirStopsEverywhere) {
  Random random(318);
  for (const char* type : {"checker", "stripes", "gradient", "noise", "marble", "wood"}) {
    const TextureForm form =
        texture_form(std::string(R"({"type":")") + type + R"(","scale":1e-9})");
    for (const double size : {1e-12, 1.0, 1e3, 1e9}) {
      for (int i = 0; i < 50; ++i) {
        const double red = red_at(form, random.point(size), size * 1e-6);
        EXPECT_TRUE(red >= 0 && red <= 1) << type << " at " << size;
      }
    }
    const double nan = std::nan("");
    const double red = red_at(form, {nan, nan, nan}, 0);
    EXPECT_TRUE(red >= 0 && red <= 1) << type;
  }
}

}  // namespace
}  // namespace tia
