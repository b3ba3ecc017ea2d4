// Keys for tests: files of them, and requests that come with one.
#pragma once

#include <fstream>
#include <string>

#include "server/access/access.h"
#include "server/access/signed_url.h"
#include "server/stores/digest.h"
#include "tests/server/process_support.h"

namespace tia::test {

/// In ns.
inline constexpr std::int64_t one_second = 1'000'000'000;

/// The entry of a key whose secret is its id and " secret".
inline std::string secret_of(const std::string& id) { return id + "-secret"; }
inline std::string entry_of(const std::string& id, const std::string& more = "",
                            const std::string& may = R"("render","scenes","metrics")") {
  const std::string digest = R"(,"sha256":")" + sha256_hex(secret_of(id)) + '"';
  return R"({"id":")" + id + '"' + (id == "anonymous" ? "" : digest) + R"(,"may":[)" + may + "]" +
         (more.empty() ? "" : ",") + more + "}";
}

/// KeyFiles: both files in a folder of their own, and the configuration that names them.
struct KeyFiles {
  static constexpr const char* hex =
      "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f";
  Folder folder;
  Config config;

  explicit KeyFiles(const std::string& entries, const std::string& signing = "") {
    config.keys_file = folder.file("keys.json");
    write("keys.json", "[" + entries + "]");
    if (signing.empty()) return;
    config.sign_file = folder.file("sign.txt");
    write("sign.txt", signing);
  }
  void write(const char* name, const std::string& text) const {
    std::ofstream(folder.file(name)) << text;
  }
  /// The bytes of `hex`.
  static std::string signing_secret() {
    std::string bytes;
    for (char byte = 0; byte < 32; ++byte) bytes += byte;
    return bytes;
  }
};

inline Request asking_as(const std::string& id, const std::string& target,
                         const std::string& method = "GET") {
  Request request{method, target, {}, "", Host::id};
  if (!id.empty())
    request.headers.emplace_back("Authorization", "Bearer " + id + "." + secret_of(id));
  return request;
}

/// What comes to a server by a connection: identified first.
inline Response ask_through(Host& host, Request request) {
  host.service().access.identify(request);
  return host.ask(request);
}

/// The reason by which it is refused, "" where it is not.
inline std::string refusal_of(Access& access, Request request,
                              const std::vector<Right>& needs = {Right::render}) {
  try {
    access.identify(request);
    access.admit(request, needs);
    return "";
  } catch (const AccessRefusal& refusal) {
    return std::string(refusal.why());
  }
}

}  // namespace tia::test
