#include "server/handlers/schema_words.h"

#include <algorithm>
#include <cmath>

#include "core/input/json.h"
#include "server/handlers/html.h"

namespace tia::server {
namespace {

constexpr std::string_view definitions = "#/$defs/";

const Value* member(const Value& schema, std::string_view word) {
  const auto* object = schema.as<Value::Object>();
  return object != nullptr ? find(*object, word) : nullptr;
}
const Value::Object& properties_of(const Value& schema) {
  static const Value::Object none;
  const Value* properties = member(schema, "properties");
  return properties != nullptr ? *properties->as<Value::Object>() : none;
}
std::string text_member(const Value& schema, std::string_view word) {
  const Value* text = member(schema, word);
  return text != nullptr && text->as<std::string>() != nullptr ? *text->as<std::string>() : "";
}
const double* number_member(const Value& schema, std::string_view word) {
  const Value* number = member(schema, word);
  return number != nullptr ? number->as<double>() : nullptr;
}

// 1000000000 as 1e9.
std::string short_number(double number) {
  const std::string text = number_text(number);
  const auto last = text.find_last_not_of('0');
  const std::size_t zeros = text.size() - 1 - last;
  if (last == text.npos || zeros < 6 || text.find('.') != text.npos) return text;
  return text.substr(0, last + 1) + "e" + std::to_string(zeros);
}

std::string range_words(const Value& schema) {
  const double *from = number_member(schema, "minimum"), *to = number_member(schema, "maximum");
  const double* above = number_member(schema, "exclusiveMinimum");
  std::string words;
  if (from != nullptr && to != nullptr)
    words = " from " + short_number(*from) + " to " + short_number(*to);
  else if (from != nullptr) words = ", at least " + short_number(*from);
  else if (above != nullptr) words = " above " + short_number(*above);
  if (from == nullptr && to != nullptr)
    words.append(words.empty() ? ", at most " : " to ").append(short_number(*to));
  if (member(schema, "not") != nullptr) words += ", not 0";
  return words;
}

std::string joined_words(const Value& list, const char* between,
                         std::string (*each)(const Value&)) {
  std::string words;
  for (const Value& one : *list.as<Value::Array>()) {
    if (!words.empty()) words += between;
    words += each(one);
  }
  return words;
}

// A text as it is, all else as JSON.
std::string plain_text(const Value& value) {
  const auto* text = value.as<std::string>();
  return text != nullptr && !text->empty() ? *text : to_json(value);
}

std::string value_words(const Value& value) { return code(plain_text(value)); }

bool is_number(const Value& schema) {
  const std::string type = text_member(schema, "type");
  return type == "number" || type == "integer";
}

// "each from 0 to 1": of a list's numbers.
std::string each_number(const Value& items) {
  std::string range = range_words(items);
  if (range.empty()) return "";
  return ", each " + range.substr(range.find_first_not_of(", "));
}

std::string array_words(const Value& schema) {
  const Value* items = member(schema, "items");
  const double *least = number_member(schema, "minItems"),
               *most = number_member(schema, "maxItems");
  const bool exact = least != nullptr && most != nullptr && *least == *most;
  const bool numbers = items != nullptr && is_number(*items);
  std::string words = exact ? number_text(*least) : numbers ? "a list of" : "a list";
  if (!exact && least != nullptr)
    words += (numbers ? " at least " : " of at least ") + number_text(*least);
  if (numbers)
    return words + (text_member(*items, "type") == "integer" ? " integers" : " numbers") +
           each_number(*items);
  if (exact) words += " values";
  if (items == nullptr || items->as<Value::Object>() == nullptr) return words;
  return words + ", each " + schema_words(*items);
}

std::string object_words(const Value& schema) {
  std::string words;
  for (const auto& [name, property] : properties_of(schema))
    words.append(words.empty() ? "an object of " : ", ")
        .append(code(name))
        .append(" (")
        .append(schema_words(property))
        .append(")");
  if (!words.empty()) return words;
  const Value* others = member(schema, "additionalProperties");
  if (others == nullptr || others->as<Value::Object>() == nullptr) return "an object";
  return "an object whose members are each " + schema_words(*others);
}

// ---- kinds ----------------------------------------------------------------------------------

std::string kind_of(const Value& alternative) {
  const Value* type = find(properties_of(alternative), "type");
  return type != nullptr ? text_member(*type, "const") : "";
}

// The alternatives that a key `type` tells apart; none where there are no such.
Value::Array kinds_of(const Value& schema) {
  const Value* list = member(schema, "oneOf");
  if (list == nullptr || member(schema, "properties") != nullptr) return {};
  const auto& all = *list->as<Value::Array>();
  const bool tagged =
      std::none_of(all.begin(), all.end(), [](const Value& each) { return kind_of(each).empty(); });
  return tagged ? all : Value::Array{};
}

bool is_common(const std::string& name, const Value& property, const Value::Array& kinds) {
  return std::all_of(kinds.begin(), kinds.end(), [&](const Value& kind) {
    const Value* same = find(properties_of(kind), name);
    return same != nullptr && *same == property;
  });
}

std::vector<FieldRow> rows_of(const Value& schema) {
  const Value* required = member(schema, "required");
  const auto needs = [&](const std::string& name) {
    if (required == nullptr) return false;
    const auto& names = *required->as<Value::Array>();
    return std::find(names.begin(), names.end(), Value(name)) != names.end();
  };
  std::vector<FieldRow> rows;
  for (const auto& [name, property] : properties_of(schema))
    rows.push_back(field_row(name, property, needs(name)));
  return rows;
}

std::string kinds_html(std::string_view name, const Value::Array& kinds) {
  const auto id_of = [&](const Value& kind) { return schema_anchor(name) + "-" + kind_of(kind); };
  std::string list, html;
  for (const Value& kind : kinds)
    list.append(list.empty() ? "" : ", ").append(link_to(id_of(kind), code(kind_of(kind))));
  std::vector<FieldRow> common = rows_of(kinds.front());
  std::erase_if(common, [&](const FieldRow& row) {
    return !is_common(row.name, *find(properties_of(kinds.front()), row.name), kinds);
  });
  common.insert(common.begin(),
                {"type", "the kind, with fields of its own", "one of " + list, "", true});
  html = fields_html(common);
  for (const Value& kind : kinds) {
    std::vector<FieldRow> own = rows_of(kind);
    std::erase_if(own, [&](const FieldRow& row) {
      return row.name == "type" || is_common(row.name, *find(properties_of(kind), row.name), kinds);
    });
    html += element("h4", code(kind_of(kind)), "id=\"" + id_of(kind) + "\"") + fields_html(own);
  }
  return html;
}

}  // namespace

std::string schema_anchor(std::string_view name) { return "json-" + std::string(name); }

std::string schema_words(const Value& schema) {
  if (const std::string to = text_member(schema, "$ref"); !to.empty()) {
    const std::string name = to.substr(definitions.size());
    return link_to(schema_anchor(name), escaped(name));
  }
  if (const Value* only = member(schema, "const")) return value_words(*only);
  if (const Value* words = member(schema, "enum"))
    return "one of " + joined_words(*words, ", ", value_words);
  for (const char* either : {"oneOf", "anyOf"})
    if (const Value* list = member(schema, either))
      return joined_words(*list, " or ", schema_words);
  if (const Value* content = member(schema, "contentSchema"))
    return "as JSON " + schema_words(*content);
  const std::string type = text_member(schema, "type");
  if (type == "number") return "a number" + range_words(schema);
  if (type == "integer") return "an integer" + range_words(schema);
  if (type == "array") return array_words(schema);
  if (type == "object") return object_words(schema);
  if (type == "boolean") return code("true") + " or " + code("false");
  if (type == "null") return code("null");
  if (type != "string") return "any value";
  const double* most = number_member(schema, "maxLength");
  return most != nullptr ? "text of at most " + number_text(*most) + " characters" : "text";
}

FieldRow field_row(std::string_view name, const Value& schema, bool required) {
  const Value* standard = member(schema, "default");
  return {std::string(name), text_member(schema, "description"), schema_words(schema),
          standard != nullptr ? plain_text(*standard) : "", required};
}

std::string fields_html(const std::vector<FieldRow>& rows) {
  std::string html;
  for (const FieldRow& row : rows) {
    std::string about = element("p", escaped(row.about)), allowed = row.allowed;
    if (row.required) allowed += "; required";
    if (!row.standard.empty()) allowed += "; default " + code(row.standard);
    if (row.about.empty()) about.clear();
    html += element("div",
                    element("dt", code(row.name)) +
                        element("dd", about + element("p", allowed, "class=\"note\"")),
                    row.id.empty() ? "" : "id=\"" + row.id + "\"");
  }
  return html.empty() ? "" : element("dl", html, "class=\"fields\"");
}

std::string schema_html(std::string_view name, const Value& schema) {
  if (const Value::Array kinds = kinds_of(schema); !kinds.empty()) return kinds_html(name, kinds);
  if (const auto rows = rows_of(schema); !rows.empty()) return fields_html(rows);
  return element("p", schema_words(schema));
}

}  // namespace tia::server
