// After start the server opens no file and keeps no descriptor.
#include <sys/resource.h>

#include <optional>

#include "tests/server/process_support.h"

namespace tia::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* served_targets[] = {"/",
                                          "/style.css",
                                          "/main.js",
                                          "/render?key=a&width=75&height=50",
                                          "/render?key=d&width=75&height=50&format=pfm",
                                          "/scenes",
                                          "/scenes/thesis",
                                          "/schema/scene.json",
                                          "/version",
                                          "/healthz",
                                          "/render?width=0",
                                          "/nowhere",
                                          "/scenes/..%2f..%2fetc%2fpasswd"};

// With no descriptor left to give, whatever opens a file fails.
TEST(Files, EveryAnswerIsGivenWithoutOpeningOne) {
  Tia tia;
  Host host;
  Connection connection(tia.port());
  connection.send("GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n");
  ASSERT_EQ(connection.receive().status, 200);
  // A sanitizer's check of virtual calls needs some now and then.
  const rlim_t left = entries(tia, "fd") + (sanitized() ? 8 : 0);
  const rlimit none{left, left};
  ASSERT_EQ(prlimit(tia.pid(), RLIMIT_NOFILE, &none, nullptr), 0);
  for (const char* target : served_targets) {
    SCOPED_TRACE(target);
    const Response direct = host.get(target);
    connection.send(std::string("GET ") + target +
                    " HTTP/1.1\r\nHost: x\r\nX-Request-Id: " + Host::id + "\r\n\r\n");
    const Response response = connection.receive();
    EXPECT_EQ(response.status, direct.status);
    EXPECT_TRUE(response.body == direct.body);
  }
}

TEST(Files, NoneIsOpenButTheStandardStreams) {
  Tia tia;
  for (const char* target : served_targets) tia.get(target);
  for (const auto& entry : fs::directory_iterator(tia.proc("fd"))) {
    if (std::stoi(entry.path().filename()) <= 2) continue;
    std::error_code closed;  // by now
    const std::string is = fs::read_symlink(entry.path(), closed).string();
    if (closed) continue;
    EXPECT_TRUE(is.starts_with("socket:") || is.starts_with("pipe:") ||
                is.starts_with("anon_inode:"))
        << is;
  }
}

TEST(Files, DescriptorsGoBackToTheStartAfterManyConnections) {
  Tia tia;
  const std::size_t before = entries(tia, "fd");
  for (int i = 0; i < 200; ++i)
    tia.get(served_targets[static_cast<std::size_t>(i) % std::size(served_targets)]);
  for (int i = 0; i < 20; ++i) Connection(tia.port()).send("GET /");
  EXPECT_TRUE(eventually([&] { return entries(tia, "fd") <= before; })) << entries(tia, "fd");
}

TEST(Files, AServerWhoseFolderIsGoneServesAllTheSame) {
  const fs::path here = fs::current_path();
  std::optional<Tia> tia;
  {
    Folder folder;
    fs::current_path(folder.file(""));
    tia.emplace();
    fs::current_path(here);
  }
  EXPECT_EQ(tia->get("/").status, 200);
  EXPECT_EQ(tia->get("/render?key=a&width=8&height=8").status, 200);
}

}  // namespace
}  // namespace tia::test
