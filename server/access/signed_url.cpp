#include "server/access/signed_url.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/input/errors.h"
#include "server/access/secrets.h"
#include "server/http/message.h"

namespace tia::server {
namespace {

// The three parameters of a signature, in their order.
constexpr std::array<std::string_view, 3> names{"exp", "kid", "sig"};

std::string name_of_parameter(std::string_view parameter) {
  const std::string_view name = parameter.substr(0, parameter.find('='));
  try {
    return percent_decode(name);
  } catch (const InputError&) {
    return std::string(name);
  }
}

bool is_of_signature(std::string_view parameter) {
  return std::ranges::find(names, name_of_parameter(parameter)) != names.end();
}

std::vector<std::string_view> parameters_of(std::string_view query) {
  std::vector<std::string_view> all;
  for (;;) {
    const auto end = query.find('&');
    all.push_back(query.substr(0, end));
    if (end == query.npos) return all;
    query.remove_prefix(end + 1);
  }
}

// The value of a parameter that is written plainly as this name, or "".
std::string_view value_as(std::string_view name, std::string_view parameter) {
  const bool is_it = parameter.starts_with(name) && parameter.substr(name.size()).starts_with('=');
  return is_it ? parameter.substr(name.size() + 1) : std::string_view();
}

// Seconds since 1970 in digits, at most until the year 33658.
std::optional<std::int64_t> seconds_in(std::string_view text) {
  if (text.empty() || text.size() > 12 || text.find_first_not_of("0123456789") != text.npos)
    return std::nullopt;
  return std::stoll(std::string(text));
}

// What the last three parameters say where they are those of a signature.
UrlSignature read_in_form(std::string_view target, const std::vector<std::string_view>& all) {
  UrlSignature signature;
  if (all.size() < names.size()) return signature;
  const auto last = std::span(all).last(names.size());
  const auto expires = seconds_in(value_as(names[0], last[0]));
  const std::string_view kid = value_as(names[1], last[1]), code = value_as(names[2], last[2]);
  if (!expires || kid.empty() || code.empty()) return signature;
  const std::size_t own = names[2].size() + 1 + code.size() + 1;  // &sig=S
  return {std::string(target.substr(0, target.size() - own)), std::string(kid), std::string(code),
          *expires, true};
}

}  // namespace

std::optional<UrlSignature> take_signature(std::string& target) {
  const auto mark = target.find('?');
  const bool may_be_signed = target.find("sig", mark) != target.npos ||
                             target.find('%', mark) != target.npos;  // which a name may be in
  if (mark == target.npos || !may_be_signed) return std::nullopt;
  const std::vector<std::string_view> all =
      parameters_of(std::string_view(target).substr(mark + 1));
  if (std::ranges::none_of(all, [](auto each) { return name_of_parameter(each) == names[2]; }))
    return std::nullopt;
  UrlSignature signature = read_in_form(target, all);
  if (std::ranges::count_if(all, is_of_signature) != std::ssize(names)) signature = {};
  std::string rest;
  for (const std::string_view each : all)
    if (!is_of_signature(each)) rest.append(rest.empty() ? "?" : "&").append(each);
  target.replace(mark, target.npos, rest);
  return signature;
}

bool is_signed_by(const UrlSignature& signature, std::string_view key) {
  return same_secret(authentication_code(key, signature.text), signature.code);
}

std::string signed_target(std::string target, std::string_view kid, std::string_view key,
                          std::int64_t expires) {
  target += target.find('?') == target.npos ? '?' : '&';
  target.append("exp=").append(std::to_string(expires)).append("&kid=").append(kid);
  const std::string code = authentication_code(key, target);
  return target.append("&sig=").append(code);
}

}  // namespace tia::server
