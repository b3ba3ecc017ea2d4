#include "server/requests/accept.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/input/errors.h"
#include "server/http/error.h"
#include "server/http/headers.h"

namespace tia::server {
namespace {

constexpr int most = 1000;

// Takes the part before the mark off the text.
std::string_view cut(std::string_view& text, char mark) {
  const std::string_view part = text.substr(0, text.find(mark));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return trimmed(part);
}

// "0.5" as 500; nothing where it is no weight: 0 or 1, a dot, at most three digits. Java's own
// client writes .2 for 0.2.
std::optional<int> weight_of(std::string_view written) {
  std::string text(written);
  if (text.starts_with('.')) text.insert(text.begin(), '0');
  if (text.empty() || text.size() > 5 || (text[0] != '0' && text[0] != '1')) return std::nullopt;
  if (text.size() > 1 && text[1] != '.') return std::nullopt;
  int weight = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    if (i == 1) continue;
    const char digit = i < text.size() ? text[i] : '0';
    if (digit < '0' || digit > '9') return std::nullopt;
    weight = 10 * weight + (digit - '0');
  }
  return weight <= most ? std::optional(weight) : std::nullopt;
}

/// One element of the list: what it names, in lower case, and its weight.
struct Wish {
  std::string_view name;
  int weight = most;
};

// An element whose weight cannot be read is left out.
std::vector<Wish> wishes(std::string_view list) {
  std::vector<Wish> all;
  while (!list.empty()) {
    std::string_view element = cut(list, ',');
    Wish wish{cut(element, ';')};
    std::optional<int> weight = most;
    while (!element.empty()) {
      const std::string_view parameter = cut(element, ';');
      if (parameter.starts_with("q=")) weight = weight_of(parameter.substr(2));
    }
    wish.weight = weight.value_or(0);
    if (!wish.name.empty() && weight) all.push_back(wish);
  }
  return all;
}

// How closely a range fits the type: 0 not at all, 3 by name.
int closeness(std::string_view range, std::string_view type) {
  if (range == type) return 3;
  if (range == "*/*" || range == "*") return 1;  // the latter is Java's
  return range.ends_with("/*") && type.starts_with(range.substr(0, range.size() - 1)) ? 2 : 0;
}

}  // namespace

int media_weight(const Request& request, std::string_view type) {
  const std::string accept = lower(joined(request, "Accept"));
  if (trimmed(accept).empty()) return most;
  int closest = 0, weight = 0;
  for (const Wish& wish : wishes(accept)) {
    const int close = closeness(wish.name, type);
    if (close <= closest) continue;
    closest = close;
    weight = wish.weight;
  }
  return weight;
}

bool takes_coding(const Request& request, std::string_view coding) {
  const std::string accept = lower(joined(request, "Accept-Encoding"));
  std::optional<int> named, any, none;
  for (const Wish& wish : wishes(accept)) {
    if (wish.name == coding) named = wish.weight;
    if (wish.name == "*") any = wish.weight;
    if (wish.name == "identity") none = wish.weight;
  }
  const int weight = named.value_or(any.value_or(0));
  return weight > 0 && weight >= none.value_or(0);
}

std::string_view preferred_type(const Request& request,
                                const std::vector<std::string_view>& types) {
  std::string_view best;
  int greatest = 0;
  for (const std::string_view type : types) {
    const int weight = media_weight(request, type);
    if (weight <= greatest) continue;
    greatest = weight;
    best = type;
  }
  if (greatest == 0)
    throw HttpError("not-acceptable",
                    "Accept allows nothing that this path gives; there is " + listed(types));
  return best;
}

}  // namespace tia::server
