// A request's parameters as one JSON object, whether they stand in the query or in the body.
#pragma once

#include <string>
#include <string_view>

#include "server/contract/text_form.h"
#include "server/http/message.h"

namespace tia::server {

/// QueryReader: takes a query apart. Names and values are written as forms write them, a space as
/// +. Errors: InputError (malformed) for bad encoding and for a name that comes twice.
class QueryReader {
 public:
  explicit QueryReader(std::string_view query) : left_(query) {}
  /// Moves on to the next name=value; false where there is none.
  bool next();
  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  /// The part of the name before its first dot, or "", and the rest.
  std::string group() const { return name_.substr(0, dot()); }
  std::string rest() const { return name_.substr(dot() == 0 ? 0 : dot() + 1); }

  /// Adds to the list of that name, or begins it.
  void add_again(Value value);
  void add(Value value) { add_once(object_, Place{}, name_, std::move(value)); }
  /// Adds it to the object of its group.
  void add_to_group(Value value);
  Value take() { return std::move(object_); }

 private:
  std::size_t dot() const {
    const std::size_t at = name_.find('.');
    return at == name_.npos ? 0 : at;
  }
  void add_once(Value::Object& object, const Place& at, const std::string& name, Value value);

  std::string_view left_;
  std::string name_, text_;
  Value::Object object_;
};

/// name=value&group.name=value as the JSON object that a POST would send.
template <class T>
Value query_object(std::string_view query) {
  QueryReader reader(query);
  while (reader.next()) {
    if (auto value = field_of_group_from_text<T>(reader.group(), reader.rest(), reader.text()))
      reader.add_to_group(std::move(*value));
    else if (comes_again<T>(reader.name()))
      reader.add_again(field_from_text<T>(reader.name(), reader.text()));
    else reader.add(field_from_text<T>(reader.name(), reader.text()));
  }
  return reader.take();
}

/// Errors: InputError (conflict) where a request with a body has a query, too.
void refuse_query(const Request& request);

/// The JSON that a body is, whatever type it declares where it starts with {: curl -d declares a
/// form. `what` says what to send. Errors: InputError; HttpError (media-type); Stopped.
Value body_json(const Request& request, const std::string& what, const JsonLimits& limits = {});

}  // namespace tia::server
