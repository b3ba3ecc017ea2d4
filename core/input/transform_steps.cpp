#include "core/input/transform_steps.h"

#include <cmath>

namespace tia {

Affine Scale::affine() const {
  if (const auto* factor = std::get_if<double>(&by))
    return Affine::scaling({*factor, *factor, *factor});
  return Affine::scaling(std::get<Vec3d>(by));
}

Affine Matrix::affine() const {
  const auto& row = by.row;
  const auto column = [&](std::size_t i) { return Vec3d{row[0][i], row[1][i], row[2][i]}; };
  return {column(0), column(1), column(2), column(3)};
}

Affine TransformSteps::affine() const {
  Affine product;
  for (const Step& step : steps)
    product = std::visit([](const auto& is) { return is.affine(); }, step) * product;
  return product;
}

bool is_usable(const Affine& map) {
  // The scales keep squares of coordinates far from the ends of double's range; a flatness of 1e-12
  // leaves four of its sixteen digits to the inverse.
  constexpr double least = 1e-9, most = 1e9, flat = 1e-12;
  const double x = length(map.x), y = length(map.y), z = length(map.z);
  const auto in_reach = [](double scale) { return scale >= least && scale <= most; };
  return in_reach(x) && in_reach(y) && in_reach(z) && std::isfinite(length(map.offset)) &&
         std::fabs(map.determinant()) >= flat * x * y * z;
}

// ---- JSON -----------------------------------------------------------------------------------

template <>
struct Codec<MatrixRows> {
  using Rows = std::array<std::array<double, 4>, 4>;
  static constexpr std::array<double, 4> last{0, 0, 0, 1};
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   MatrixRows& out) {
    const std::size_t before = faults.count();
    read_value(v, at, spec, faults, out.row);
    if (faults.count() == before && out.row[3] != last)
      faults.add({FaultKind::out_of_range, at.at(3).pointer(), write_value(out.row[3]),
                  "[0,0,0,1]: a matrix that keeps points points"});
  }
  static Value write(const MatrixRows& v) { return write_value(v.row); }
  static Value schema(const Spec& spec, Definitions& named) {
    Value::Object rows = *schema_of<Rows>(spec, named).as<Value::Object>();
    const Value row = *find(rows, "items"), fixed = Value::Object{{"const", write_value(last)}};
    rows.emplace_back("prefixItems", Value::Array{row, row, row, fixed});
    return rows;
  }
};

namespace {

using Step = TransformSteps::Step;

std::string one_step() {
  return "one of " + listed({Translate::key, RotateDegrees::key, Scale::key, Matrix::key,
                             RotateQuaternion::key});
}

void check_map(const Affine& map, const Place& at, const Value& got, const char* what,
               Faults& faults) {
  if (is_usable(map)) return;
  faults.add({FaultKind::out_of_range, at.pointer(), excerpt(got),
              std::string(what) + " scale every axis by 1e-9 to 1e9 and can be undone"});
}

// Reads the Kind's value where the step has its key.
template <class Kind>
void read_kind(detail::MemberReader& from, Step& out) {
  const Value* value = from.member(Kind::key);
  if (value == nullptr) return;
  const Place at = from.at.at(Kind::key);
  const std::size_t before = from.faults.count();
  Kind& kind = out.emplace<Kind>();
  read_value(*value, at, Kind::spec, from.faults, kind.by);
  if (from.faults.count() == before)
    check_map(kind.affine(), at, *value, "numbers that", from.faults);
}

void read_step(const Value& v, const Place& at, Faults& faults, Step& out) {
  const auto* object = v.as<Value::Object>();
  if (object == nullptr)
    return detail::wrong_type(v, at, "an object with one key, " + one_step(), faults);
  if (object->empty())
    return faults.add({FaultKind::missing, at.pointer(), std::nullopt, one_step()});
  detail::MemberReader from{*object, at, faults};
  const std::size_t before = faults.count();
  read_kind<Translate>(from, out);
  read_kind<RotateDegrees>(from, out);
  read_kind<Scale>(from, out);
  read_kind<Matrix>(from, out);
  read_kind<RotateQuaternion>(from, out);
  from.finish();
  if (faults.count() == before && object->size() > 1)
    faults.add({FaultKind::conflict, at.pointer(), excerpt(v), "one key a step, " + one_step()});
}

template <class Kind>
Value kind_schema(Definitions& named) {
  detail::ObjectSchema schema;
  Spec spec = Kind::spec;
  spec.required = true;
  schema.add(Kind::key, schema_of<decltype(Kind::by)>(spec, named), spec, std::nullopt);
  return schema.finish();
}

}  // namespace

void Codec<TransformSteps>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                                 TransformSteps& out) {
  const auto* list = detail::read_array(v, at, spec, faults);
  if (list == nullptr) return;
  const std::size_t before = faults.count();
  TransformSteps placement;
  placement.steps.reserve(detail::places<Step>(*list));
  for (std::size_t i = 0; i < list->size() && !faults.full(); ++i)
    read_step((*list)[i], at.at(i), faults, placement.steps.emplace_back());
  if (faults.count() != before) return;
  check_map(placement.affine(), at, v, "steps that together", faults);
  if (faults.count() == before) out = std::move(placement);
}

Value Codec<TransformSteps>::write(const TransformSteps& v) {
  Value::Array steps;
  for (const Step& step : v.steps)
    steps.push_back(std::visit(
        [](const auto& is) -> Value {
          return Value::Object{{std::string(is.key), write_value(is.by)}};
        },
        step));
  return steps;
}

Value Codec<TransformSteps>::schema(const Spec&, Definitions& named) {
  const Value step = Value::Object{
      {"oneOf", Value::Array{kind_schema<Translate>(named), kind_schema<RotateDegrees>(named),
                             kind_schema<Scale>(named), kind_schema<Matrix>(named),
                             kind_schema<RotateQuaternion>(named)}}};
  return Value::Object{{"type", "array"}, {"items", step}};
}

std::string Codec<TransformSteps>::allowed(const Spec& spec) { return detail::array_text(spec); }

}  // namespace tia
