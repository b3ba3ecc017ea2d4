// A kind that is only half added to one of the lists does not compile. Each half kind below lacks
// one thing; that it is refused is checked by the compiler, and costs nothing.
#include <gtest/gtest.h>

#include "core/integrators/integrator.h"
#include "core/lights/light.h"
#include "core/materials/material.h"
#include "core/shapes/shape.h"

namespace tia {
namespace half {

template <class Kind>
struct Described {
  static constexpr std::string_view type = "half";
  template <class Visitor>
  static void fields(Visitor&&) {}
};

// ---- shapes ---------------------------------------------------------------------------------

struct ShapeWithoutForm : Described<ShapeWithoutForm> {};
static_assert(!IsShape<ShapeWithoutForm>);

struct FormWithoutUv {
  static constexpr bool solid = false;
};
int elements(const FormWithoutUv&);
Aabb bounds(const FormWithoutUv&);
void crossings(const FormWithoutUv&, const Line&, auto emit);
Vec3d normal(const FormWithoutUv&, const Vec3d&, int);
struct ShapeOfHalfForm : Described<ShapeOfHalfForm> {};
FormWithoutUv prepare(const ShapeOfHalfForm&);
static_assert(!IsForm<FormWithoutUv> && !IsShape<ShapeOfHalfForm>);

struct WholeForm : FormWithoutUv {};
Vec2d uv(const WholeForm&, const Vec3d&, int);
struct NamelessShape {
  template <class Visitor>
  static void fields(Visitor&&) {}
};
WholeForm prepare(const NamelessShape&);
static_assert(IsForm<WholeForm> && !IsShape<NamelessShape>);

// It owns a list and does not tell how much.
struct FormOfUntoldSize : WholeForm {
  struct Owner {
    std::vector<double> list;
  } owner;
};
static_assert(!IsForm<FormOfUntoldSize>);

struct WrongHooks : WholeForm {};
double work_of(const WrongHooks&);
void spans(const WrongHooks&, const Line&);
Crossing first_crossing(const WrongHooks&, const Line&, double, double);
static_assert(IsForm<WrongHooks> && !TellsWork<WrongHooks> && !HasSpans<WrongHooks> &&
              !FindsFirstCrossing<WrongHooks>);

// Its elements are numbered, and no one asks whether the numbers have materials.
struct UncheckedNumbers : Described<UncheckedNumbers> {};
struct NumberedForm : WholeForm {};
int material_number(const NumberedForm&, int);
NumberedForm prepare(const UncheckedNumbers&);
static_assert(IsSurface<UncheckedNumbers> && !IsShape<UncheckedNumbers>);

struct UntoldComposite : Described<UntoldComposite> {
  std::vector<Object> children;
};
const std::vector<Object>& children_in(const UntoldComposite& composite);
static_assert(!IsShape<UntoldComposite>);

// ---- materials, textures --------------------------------------------------------------------

struct MaterialWithoutMatter : Described<MaterialWithoutMatter> {};
const Texture* texture_of(const MaterialWithoutMatter&);
static_assert(!IsMaterial<MaterialWithoutMatter>);

struct MaterialWithoutTexture : Described<MaterialWithoutTexture> {};
ShadingParameters shading_of(const MaterialWithoutTexture&, const Vec3d&);
static_assert(!IsMaterial<MaterialWithoutTexture>);

struct ColorlessForm {};
struct TextureWithoutColor : Described<TextureWithoutColor> {};
ColorlessForm prepare(const TextureWithoutColor&);
static_assert(!IsTexture<TextureWithoutColor>);

// ---- lights ---------------------------------------------------------------------------------

struct PlainForm {};
LightSample<Wide> sample_li(const PlainForm&, const Vec3<Wide>&);
struct PlaneForm {  // that shines from an area
  Constant middle;
};
LightSample<Wide> sample_li(const PlaneForm&, const Vec3<Wide>&, const Wide&, const Wide&);
Wide pdf_li(const PlaneForm&, const Vec3<Wide>&, const Vec3<Wide>&, const Wide&);

template <class Kind>
struct Near : Described<Kind> {
  static constexpr bool endless = false;
  void move_by(const Vec3d&);
};

struct WholeLight : Near<WholeLight> {};
PlainForm prepare(const WholeLight&);
static_assert(IsLight<WholeLight>);

struct LightWithoutForm : Near<LightWithoutForm> {};
static_assert(!IsLight<LightWithoutForm>);

// It would stay behind where the world moves its origin.
struct LightThatStays : Described<LightThatStays> {
  static constexpr bool endless = false;
};
PlainForm prepare(const LightThatStays&);
static_assert(!IsLight<LightThatStays>);

struct LightOfUntoldDistance : Described<LightOfUntoldDistance> {
  void move_by(const Vec3d&);
};
PlainForm prepare(const LightOfUntoldDistance&);
static_assert(!IsLight<LightOfUntoldDistance>);

struct BackgroundWithForm : Near<BackgroundWithForm> {
  static constexpr bool background = true;
};
PlainForm prepare(const BackgroundWithForm&);
static_assert(!IsLight<BackgroundWithForm>);

// It has a place, and no key could move it.
struct LightWithoutMove : Near<LightWithoutMove> {
  static constexpr const char* place_field = "position";
  bool waits() const;
  std::optional<Vec3d> place() const;
};
PlainForm prepare(const LightWithoutMove&);
static_assert(!IsLight<LightWithoutMove>);

struct LightWithWrongMove : LightWithoutMove {
  void move_to(const Vec3d&);
};
PlainForm prepare(const LightWithWrongMove&);
static_assert(!IsLight<LightWithWrongMove>);

struct SamplesWithoutArea : Near<SamplesWithoutArea> {
  int samples = 1;
};
PlainForm prepare(const SamplesWithoutArea&);
static_assert(!IsLight<SamplesWithoutArea>);

struct AreaWithoutSamples : Near<AreaWithoutSamples> {};
PlaneForm prepare(const AreaWithoutSamples&);
Sphere surface(const AreaWithoutSamples&);
static_assert(!IsLight<AreaWithoutSamples>);

struct UnseenArea : Near<UnseenArea> {
  int samples = 1;
};
PlaneForm prepare(const UnseenArea&);
static_assert(AreaLight<UnseenArea> && !IsLight<UnseenArea>);

struct SeenArea : UnseenArea {};
PlaneForm prepare(const SeenArea&);
Sphere surface(const SeenArea&);
static_assert(IsLight<SeenArea>);

// A path that hits it could not tell how often it asks for it.
struct FormWithoutDensity {
  Constant middle;
};
LightSample<Wide> sample_li(const FormWithoutDensity&, const Vec3<Wide>&, const Wide&, const Wide&);
static_assert(ShinesFromPoint<FormWithoutDensity> && !LitForm<FormWithoutDensity>);

// Few plain balls are lit by a form's middle, all others by what comes in: they must not differ.
struct FormOfTwoMinds {
  Constant middle;
};
LightSample<Wide> sample_li(const FormOfTwoMinds&, const Vec3<Wide>&);
static_assert(ShinesFromPoint<FormOfTwoMinds> && !LitForm<FormOfTwoMinds>);
struct LightOfTwoMinds : Near<LightOfTwoMinds> {};
FormOfTwoMinds prepare(const LightOfTwoMinds&);
static_assert(!IsLight<LightOfTwoMinds>);

struct DarkForm {};
struct LightThatSendsNothing : Near<LightThatSendsNothing> {};
DarkForm prepare(const LightThatSendsNothing&);
static_assert(!IsLight<LightThatSendsNothing>);

// A point needs no more than its middle; what is less in some direction is none.
struct PointWithoutPlace : Near<PointWithoutPlace> {};
PointForm prepare(const PointWithoutPlace&);
static_assert(IsLight<PointWithoutPlace>);
static_assert(ShinesFromPoint<SphereForm> && ShinesFromPoint<QuadForm>);
static_assert(!ShinesFromPoint<SpotForm> && !ShinesFromPoint<DirectionalForm>);

}  // namespace half

namespace {

TEST(Lists, HalfAKindDoesNotCompile) { SUCCEED() << "or this file would not"; }

TEST(Lists, EveryIntegratorHasItsRowAndASentence) {
  for (const IntegratorRow& row : integrators) {
    EXPECT_EQ(name_of(row.name), row.text);
    EXPECT_GT(std::string_view(row.about).size(), 10U) << row.text;
    EXPECT_TRUE(row.gathers_light() || !row.is_whitted) << row.text;
  }
}

}  // namespace
}  // namespace tia
