// The whole service under a crowd, and going down in the middle of it (run under TSan, too).
#include <atomic>
#include <memory>

#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

struct Tally {
  std::atomic<int> right = 0, wrong = 0, refused = 0, broken_off = 0;
};

/// What a client of the crowd asks, again and again, and what it must get.
struct Wish {
  std::string request;
  Response due;
};

std::string get_request(const std::string& target) {
  return "GET " + target + " HTTP/1.1\r\nHost: x\r\nX-Request-Id: test-1\r\n\r\n";
}

std::vector<Wish> wishes(Host& host) {
  std::vector<Wish> all;
  for (const char* target :
       {"/healthz", "/render?key=a&width=40&height=30", "/render?width=0", "/scenes/thesis", "/",
        "/render?scene=whitted&width=24&height=18", "/explain?x=3&y=4&width=32&height=24", "/x"})
    all.push_back({get_request(target), host.get(target)});
  const std::string body = R"({"key":"d","width":40,"height":30})";
  all.push_back({"POST /render HTTP/1.1\r\nHost: x\r\nContent-Length: " +
                     std::to_string(body.size()) + "\r\n\r\n" + body,
                 host.post("/render", body)});
  return all;
}

// One request on a connection that the client may leave at once.
void ask(const Wish& wish, int port, bool leaves, Tally& tally) {
  try {
    Connection connection(port);
    connection.send(wish.request);
    if (leaves) return;
    const Response response = connection.receive();
    if (response.status == 429 || response.status == 503 || response.status == 0) ++tally.refused;
    else if (response.status == wish.due.status && response.body == wish.due.body) ++tally.right;
    else ++tally.wrong;
  } catch (const std::runtime_error&) {
    ++tally.broken_off;  // the server's door is closed, or closes
  }
}

TEST(Shutdown, UnderSixtyFourMixedClientsEveryAnswerIsWholeAndRight) {
  auto server = std::make_unique<Server>();
  const int port = server->port();
  const std::vector<Wish> all = wishes(server->host());
  Tally before, during;
  std::atomic<bool> stopping = false, ending = false;
  std::vector<std::jthread> crowd;
  for (std::size_t client = 0; client < 64; ++client)
    crowd.emplace_back([&, client] {
      for (std::size_t i = 0; !ending && during.broken_off < 1000; ++i) {
        const bool late = stopping;
        ask(all[(client + i) % all.size()], port, (client + i) % 5 == 0, late ? during : before);
      }
    });
  EXPECT_TRUE(eventually([&] { return before.right > 400; }, seconds(60)));
  stopping = true;
  server.reset();  // stops, and waits for what has come
  ending = true;
  crowd.clear();
  EXPECT_EQ(before.wrong + during.wrong, 0);
  EXPECT_GT(before.right, 400);
}

}  // namespace
}  // namespace tia::test
