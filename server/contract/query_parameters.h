// The parameters of a query as OpenAPI describes them, from the fields of a request.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/contract/text_form.h"

namespace tia::server {

/// How a field stands in a query, as OpenAPI describes it.
template <class T>
struct InQuery : TextForm<T> {};
template <class T>
struct InQuery<std::optional<T>> : InQuery<T> {};
template <>
struct InQuery<std::vector<Vec3d>> : TextForm<std::vector<Vec3d>> {};
template <Described T>
struct InQuery<std::vector<T>> : TextForm<std::vector<T>> {};
template <class T>
struct InQuery<std::vector<T>> {
  static Value::Object in_query(Value::Object schema) { return list_in_query(std::move(schema)); }
};

/// The parameter called `name`, by the schema of its JSON and how that stands in a query.
/// `standard` is what holds without it.
Value::Object query_parameter(const std::string& name, const Spec& spec, const Value& schema,
                              const std::optional<Value>& standard,
                              Value::Object (*in_query)(Value::Object));

/// Visitor: makes a parameter of every field, and of the fields of a group, "ray.origin", too.
struct QueryParameters {
  Definitions& named;
  std::string group = {};  ///< with its dot
  Value::Array list = {};

  template <class Base, class Member>
  void operator()(std::string_view field, Member Base::*member, const Spec& spec) {
    const std::string name = group + std::string(field);
    std::optional<Value> standard;
    if constexpr (!detail::is_optional<Member>) standard = write_value(Base{}.*member);
    list.push_back(query_parameter(name, spec, schema_of<Member>(spec, named), standard,
                                   InQuery<Member>::in_query));
    if constexpr (detail::is_optional<Member>)
      if constexpr (Described<typename Member::value_type>) {
        QueryParameters inner{named, name + "."};
        Member::value_type::fields(inner);
        list.insert(list.end(), inner.list.begin(), inner.list.end());
      }
  }
};

/// The parameters that query_object<T> reads.
template <Described T>
Value::Array query_parameters(Definitions& named) {
  QueryParameters visitor{named};
  T::fields(visitor);
  return std::move(visitor.list);
}

}  // namespace tia::server
