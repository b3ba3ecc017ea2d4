// Bodies that are too long for memory: put away as they come, by a thread that may have to wait.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <mutex>

#include "server/contract/problem.h"
#include "server/http/request_reader.h"
#include "tests/server/http/held.h"

namespace tia::test {
namespace {

/// Where long bodies go: what has come, as it came; each portion may have to wait, or fail.
struct Place : LongBody {
  void append(std::string_view some) override {
    if (before) before(size());
    const std::lock_guard lock(mutex);
    bytes += some;
    longest = std::max(longest, some.size());
  }
  std::size_t size() const override {
    const std::lock_guard lock(mutex);
    return bytes.size();
  }

  mutable std::mutex mutex;
  std::function<void(std::size_t)> before;
  std::string bytes;
  std::size_t longest = 0;
};

/// Places: an application that puts long bodies away and says where a body was and what it was.
class Places {
 public:
  explicit Places(std::function<void(std::size_t)> before = nullptr) : before_(std::move(before)) {}

  Application application() {
    Application application = answering([](const Request& request) {
      const auto* const place = dynamic_cast<const Place*>(request.long_body.get());
      EXPECT_TRUE(place == nullptr || request.body.empty());
      EXPECT_EQ(request.body_bytes(), (place != nullptr ? place->bytes : request.body).size());
      return text((place != nullptr ? "away " : "here ") +
                  std::to_string(place != nullptr ? place->longest : 0) + " " +
                  (place != nullptr ? place->bytes : request.body));
    });
    application.long_body = [this](const Request& request) -> std::shared_ptr<LongBody> {
      if (request.target == "/here") return nullptr;
      auto place = std::make_shared<Place>();
      place->before = before_;
      const std::lock_guard lock(mutex_);
      last_ = place;
      return place;
    };
    application.body_limit = [](const Request&) { return BodyLimit{64 << 20}; };
    application.at_once = [](const Request& request) { return request.method == "GET"; };
    return application;
  }
  /// The place that was last asked for, while there is one.
  std::shared_ptr<Place> last() const {
    const std::lock_guard lock(mutex_);
    return last_.lock();
  }

 private:
  mutable std::mutex mutex_;
  std::weak_ptr<Place> last_;
  std::function<void(std::size_t)> before_;
};

std::string numbered_body(std::size_t bytes) {
  std::string body;
  while (body.size() < bytes) body += std::to_string(body.size()) + ' ';
  return body.substr(0, bytes);
}
std::string sized_post(const std::string& body, const std::string& target = "/away") {
  return "POST " + target +
         " HTTP/1.1\r\nHost: x\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" +
         body;
}
std::string chunked_post(const std::string& body) {
  std::string chunks;
  for (std::size_t at = 0; at < body.size(); at += 0xABCD) {
    const std::string chunk = body.substr(at, 0xABCD);
    char digits[20];
    std::snprintf(digits, sizeof digits, "%zx\r\n", chunk.size());
    chunks += digits + chunk + "\r\n";
  }
  return "POST /away HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: chunked\r\n\r\n" + chunks +
         "0\r\n\r\n";
}

/// ToldBody: what the application has said of a body.
struct ToldBody {
  std::string where;
  std::size_t longest = 0;
  std::string bytes;
};
ToldBody told_by(const Response& response) {
  const auto first = response.body.find(' '), second = response.body.find(' ', first + 1);
  if (response.status != 200 || second == std::string::npos) return {response.body, 0, ""};
  return {response.body.substr(0, first), std::stoul(response.body.substr(first + 1)),
          response.body.substr(second + 1)};
}

TEST(LongBody, ComesWholeAndInOrderWhileLittleIsHeld) {
  Places places;
  Serving serving(places.application());
  const std::string body = numbered_body(5'000'000);
  for (const std::string& request : {sized_post(body), chunked_post(body)}) {
    const ToldBody told = told_by(exchange(serving.port(), request));
    EXPECT_EQ(told.where, "away");
    EXPECT_TRUE(told.bytes == body);
    // The first megabyte of chunks, whose sum nobody knows; else a portion and what comes beside.
    const bool is_sized = request.find("chunked") == std::string::npos;
    EXPECT_LE(told.longest, is_sized ? 400'000 : longest_held_body + 100'000);
  }
}

TEST(LongBody, OfAMegabyteStaysInMemory) {
  Places places;
  Serving serving(places.application());
  for (const auto& post : {+[](const std::string& body) { return sized_post(body); }, chunked_post})
    for (const std::size_t bytes : {std::size_t{1'048'576}, std::size_t{1'048'577}}) {
      const ToldBody told = told_by(exchange(serving.port(), post(numbered_body(bytes))));
      EXPECT_EQ(told.where, bytes == 1'048'576 ? "here" : "away");
      EXPECT_TRUE(told.bytes == numbered_body(bytes));
    }
}

TEST(LongBody, ForWhichThereIsNoPlaceStaysInMemory) {
  Places places;
  Serving serving(places.application());
  const ToldBody told =
      told_by(exchange(serving.port(), sized_post(numbered_body(2'000'000), "/here")));
  EXPECT_EQ(told.where, "here");
  EXPECT_TRUE(told.bytes == numbered_body(2'000'000));
}

TEST(LongBody, IsFollowedByTheNextRequestOfTheConnection) {
  Places places;
  Serving serving(places.application());
  Connection connection(serving.port());
  connection.send(sized_post(numbered_body(1'100'000)) + sized_post("short") +
                  chunked_post(numbered_body(1'200'000)));
  EXPECT_EQ(told_by(connection.receive()).bytes.size(), 1'100'000U);
  EXPECT_EQ(told_by(connection.receive()).bytes, "short");
  EXPECT_EQ(told_by(connection.receive()).bytes.size(), 1'200'000U);
}

TEST(LongBody, IsRefusedWithWhatItsPlaceSaysAndNothingIsLeftOfIt) {
  Places places([](std::size_t bytes) {
    if (bytes > 500'000) throw HttpError("storage-full", "no room");
  });
  Serving serving(places.application());
  Connection connection(serving.port());
  connection.send(sized_post(numbered_body(4'000'000)));
  EXPECT_EQ(connection.receive().status, 507);
  EXPECT_TRUE(eventually([&] { return places.last() == nullptr; }));
}

TEST(LongBody, WhoseClientLeavesIsGone) {
  Places places;
  Serving serving(places.application());
  {
    Wire wire(serving.port());
    wire.send(sized_post(numbered_body(2'000'000)).substr(0, 1'500'000));
    EXPECT_TRUE(eventually([&] {
      const auto place = places.last();
      return place && place->size() > 1'000'000;
    }));
  }
  EXPECT_TRUE(eventually([&] { return places.last() == nullptr; }));
}

TEST(LongBody, KeepsNobodyElseWaitingWhileItWaits) {
  Latch let_go;
  Places places([&](std::size_t) { let_go.wait(); });
  Serving serving(places.application());
  Wire slow(serving.port());
  const std::string request = sized_post(numbered_body(1'500'000));
  slow.offer(request.substr(0, 400'000));
  ASSERT_TRUE(eventually([&] { return places.last() != nullptr; }));
  EXPECT_EQ(exchange(serving.port(), plain_get).status, 200);
  EXPECT_EQ(told_by(exchange(serving.port(), sized_post("short"))).bytes, "short");
  let_go.open();
}

TEST(LongBody, ThatTakesItsPlaceTooLongIs503AndNotTheClientsFault) {
  Latch let_go;
  Places places([&](std::size_t) { let_go.wait(); });
  HttpOptions options = any_port();
  options.deadline = milliseconds(100);
  Serving serving(places.application(), options);
  Connection connection(serving.port());
  connection.send(sized_post(numbered_body(1'100'000)));
  const Response response = connection.receive();
  EXPECT_EQ(response.status, 503);
  EXPECT_EQ(problem_of(response).type, "/problems/storage");
  let_go.open();
  EXPECT_TRUE(eventually([&] { return places.last() == nullptr; }));
}

}  // namespace
}  // namespace tia::test
