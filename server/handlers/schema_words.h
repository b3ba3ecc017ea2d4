// A JSON Schema in words, as HTML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/input/value.h"

namespace tia::server {

/// FieldRow: a line of a list of fields.
struct FieldRow {
  std::string name, about;
  std::string allowed;   ///< as HTML
  std::string standard;  ///< the default, "" = none
  bool required = false;
  std::string id = {};  ///< to link to, "" = none
};

/// What obeys the schema: "a number from 0 to 1", "a list of", with links to named schemas.
std::string schema_words(const Value& schema);

/// Where on the page a named schema is told of.
std::string schema_anchor(std::string_view name);

/// A row of a property's schema.
FieldRow field_row(std::string_view name, const Value& schema, bool required);

/// The list of fields.
std::string fields_html(const std::vector<FieldRow>& rows);

/// All about a named schema: its fields, those of each kind where it has kinds.
std::string schema_html(std::string_view name, const Value& schema);

}  // namespace tia::server
