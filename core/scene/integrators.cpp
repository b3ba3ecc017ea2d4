#include "core/scene/integrators.h"

namespace tia {

Value Codec<IntegratorName>::schema(const Spec& spec) {
  Value::Object schema = *NamesCodec<IntegratorName>::schema(spec).as<Value::Object>();
  Value::Array each;
  for (const IntegratorRow& row : integrators) {
    Value::Object one{{"const", row.text},
                      {"description", row.about},
                      {"x-gathers", row.gathers_light() ? "light" : "features"}};
    if (row.samples != 1) one.emplace_back("x-samples", row.samples);
    if (row.max_depth != 5) one.emplace_back("x-max-depth", row.max_depth);
    each.emplace_back(std::move(one));
  }
  schema.emplace_back("oneOf", std::move(each));
  return schema;
}

namespace {

template <class Is>
std::string names_of(Is is) {
  std::string names;
  for (const IntegratorRow& row : integrators)
    if (is(row)) names.append(names.empty() ? "" : " or ").append(row.text);
  return names;
}

}  // namespace

std::string explained_names() {
  return names_of(
      [](const IntegratorRow& row) { return row.is_whitted || row.name == IntegratorName::path; });
}
std::string chance_names() {
  return names_of([](const IntegratorRow& row) { return row.is_chance(); });
}

}  // namespace tia
