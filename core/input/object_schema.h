// Schemas of objects that code writes member by member: answers, which no fields() describes.
#pragma once

#include <string_view>
#include <vector>

#include "core/input/codec.h"

namespace tia {

/// SchemaMember: one member of such an object.
struct SchemaMember {
  std::string_view name;
  Value schema;
  std::string_view about = "";
  bool always = true;  ///< else it may be missing
};

/// The schema of an object of these members and no others.
Value object_schema(std::vector<SchemaMember> members);
/// Of an integer that is not below `least`.
Value count_schema(int least = 0);
/// Of a list whose elements obey `items`, and of what is null or obeys `schema`.
Value list_schema(Value items);
Value nullable_schema(Value schema);

/// The schema of a T that refers to nothing: a number, a word, a vector.
template <class T>
Value plain_schema(const Spec& spec = {}) {
  Definitions none;
  return schema_of<T>(spec, none);
}

}  // namespace tia
