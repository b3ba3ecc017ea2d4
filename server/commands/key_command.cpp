// `tia key` and `tia sign`: what an operator makes for others to ask with.
#include <iostream>
#include <stdexcept>

#include "core/input/json.h"
#include "server/access/access.h"
#include "server/access/secrets.h"
#include "server/access/signed_url.h"
#include "server/commands/commands.h"
#include "server/commands/flags.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& got,
                         const std::string& allowed) {
  throw std::invalid_argument(what + ": got " + got + ", allowed: " + allowed);
}

// Where a URL's path begins, which alone is signed: a server need not know its own name.
std::size_t path_of(const std::string& url) {
  const auto scheme = url.find("://");
  const bool is_path = url.starts_with('/');
  const auto at = is_path ? 0 : scheme == url.npos ? url.npos : url.find('/', scheme + 3);
  if (at == url.npos)
    refuse("URL", url, "a path, or a URL with one, such as http://localhost:8080/render?key=a");
  return at;
}

// Two lines: what to send after `Authorization: Bearer `, which nobody can tell again, and the
// entry for TIA_KEYS_FILE.
void print_new_key(const std::string& id) {
  const auto is = KeyId::parse(id);
  if (!is || id == KeyEntry::anonymous) refuse("ID", id, KeyId::form);
  const std::string secret = random_secret();
  KeyEntry entry;
  entry.id = *is;
  entry.sha256 = sha256_hex(secret);
  entry.may = {Right::render, Right::explain, Right::scenes, Right::models, Right::jobs};
  std::cout << id << '.' << secret << '\n' << to_json(write_value(entry)) << std::endl;
}

struct SignAsked {
  std::string url;
  double seconds = 3600;
};

// By the first line of TIA_SIGN_FILE.
void print_signed_url(const SignAsked& asked, const Config& config) {
  const std::string& url = asked.url;
  const std::size_t at = path_of(url);
  std::string target = url.substr(at);
  if (target.find('#') != target.npos) refuse("URL", url, "one without a fragment");
  std::string unsigned_target = target;
  if (take_signature(unsigned_target)) refuse("URL", unsigned_target, "one without a signature");
  const SigningKey key = signing_keys_of(config).front();
  const auto expires = system_time() / 1'000'000'000 + static_cast<std::int64_t>(asked.seconds);
  target = signed_target(std::move(target), key.name, key.secret, expires);
  if (target.size() > longest_target)
    refuse("URL", std::to_string(target.size()) + " bytes with its signature",
           "at most " + std::to_string(longest_target));
  std::cout << url.substr(0, at) << target << std::endl;
}

}  // namespace

void add_key(CommandLine& line) {
  auto& id = line.keep<std::string>();
  Command key =
      line.add("key", "make a secret, and its entry for TIA_KEYS_FILE", [&] { print_new_key(id); });
  key.word("ID", id, "what the key is called");
}

void add_sign(CommandLine& line) {
  auto& asked = line.keep<SignAsked>();
  Command sign = line.add("sign", "sign a URL by the first line of TIA_SIGN_FILE",
                          [&] { print_signed_url(asked, line.config()); });
  sign.takes_all();
  sign.word("URL", asked.url, "a URL, or its path and query");
  sign.option("--for", asked.seconds, 1, 1e9, "for how many seconds it holds [3600]");
}

}  // namespace tia::server
