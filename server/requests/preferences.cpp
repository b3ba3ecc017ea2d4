#include "server/requests/preferences.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "core/input/errors.h"
#include "server/http/headers.h"

namespace tia::server {
namespace {

int seconds_in(std::string_view text) {
  int seconds = -1;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || seconds < 0 ||
      seconds > Preferences::longest_wait_s)
    throw InputError({FaultKind::out_of_range, "/Prefer", excerpt(Value(text)),
                      "wait=N, an integer from 0 to 60, in s"});
  return seconds;
}

}  // namespace

Preferences preferences_of(const Request& request) {
  Preferences preferences;
  const std::string list = joined(request, "Prefer");
  for (std::string_view left = list; !left.empty();) {
    std::string_view each = left.substr(0, left.find(','));
    left.remove_prefix(std::min(left.size(), each.size() + 1));
    each = trimmed(each.substr(0, each.find(';')));
    const std::string_view name = trimmed(each.substr(0, each.find('=')));
    if (same_word(name, "respond-async")) preferences.respond_async = true;
    if (same_word(name, "wait") && name.size() < each.size())
      preferences.wait_s = seconds_in(trimmed(each.substr(each.find('=') + 1)));
  }
  return preferences;
}

}  // namespace tia::server
