#include "tests/server/load/siege_support.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>

#include "tests/core/film/files.h"
#include "tests/core/film/png_chunks.h"
#include "tests/server/http/wire.h"
#include "tests/server/requests/recipe_support.h"

namespace tia::test {

// ---- asking ---------------------------------------------------------------------------------

namespace {

/// Socket: one to 127.0.0.1, which knows when its time is up.
class Socket {
 public:
  Socket(int port, Clock::duration timeout)
      : socket_(::socket(AF_INET, SOCK_STREAM, 0)), until_(Clock::now() + timeout) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) leave();
  }
  ~Socket() { leave(); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  // Returns: whether all was sent.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      if (!ready(POLLOUT)) return false;
      const ssize_t n = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (n <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }
  // All until the server closes, or what has come when the time is up.
  std::string rest() {
    std::string all(1 << 16, '\0');
    std::size_t size = 0;
    while (ready(POLLIN)) {
      const ssize_t n = ::recv(socket_, all.data() + size, all.size() - size, 0);
      if (n <= 0) return all.substr(0, size);
      size += static_cast<std::size_t>(n);
      if (size == all.size()) all.resize(2 * size);
    }
    return "";
  }

 private:
  bool ready(short what) const {
    const auto left = std::chrono::duration_cast<milliseconds>(until_ - Clock::now());
    pollfd poll{socket_, what, 0};
    return socket_ >= 0 && left.count() > 0 && ::poll(&poll, 1, static_cast<int>(left.count())) > 0;
  }
  void leave() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }

  int socket_;
  Clock::time_point until_;
};

}  // namespace

int Asker::ask(const std::string& method, const std::string& target, const std::string& body,
               Clock::duration timeout, const char* type) {
  std::string head = method + ' ' + target +
                     " HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n" +
                     "X-Forwarded-For: " + address_ + "\r\n";
  if (method == "POST")
    head += std::string("Content-Type: ") + type +
            "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n";
  Socket socket(port_, timeout);
  socket.send(head + "\r\n");  // an answer may come before all is sent
  socket.send(body);
  const std::string answer = socket.rest();
  body_ = body_of(answer);
  return status_of(answer);
}

// ---- who only asks a little ----------------------------------------------------------------

double Neighbour::pictures_a_second(Clock::duration time) {
  const auto start = Clock::now();
  int good = 0;
  for (auto frame = start; frame - start < time;) {
    const std::string x = std::to_string(last_++ * 1e-4);
    good += asker_.ask("GET", "/render?width=320&height=240&light=" + x + ",4,-3") == 200 ? 1 : 0;
    frame = std::max(frame + milliseconds(16), Clock::now());
    std::this_thread::sleep_until(frame);
  }
  return good / std::chrono::duration<double>(Clock::now() - start).count();
}

double Neighbour::health_ms(Clock::duration time) {
  std::vector<double> ms;
  for (const auto start = Clock::now(); Clock::now() - start < time;) {
    const auto asked = Clock::now();
    EXPECT_EQ(asker_.ask("GET", "/healthz"), 200);
    ms.push_back(ms_since(asked));
    std::this_thread::sleep_for(milliseconds(5));
  }
  const auto at = ms.begin() + static_cast<std::ptrdiff_t>(ms.size()) * 95 / 100;
  std::nth_element(ms.begin(), at, ms.end());
  return *at;
}

// ---- attacks --------------------------------------------------------------------------------

namespace {

std::string listed(std::size_t count, const std::string& item) {
  std::string text = "[" + item;
  for (std::size_t i = 1; i < count; ++i) text += ',' + item;
  return text + ']';
}

// Another scene for every turn, which nothing that is kept helps.
std::string drawn(const std::string& scene, int turn, const std::string& more = "") {
  return R"({"width":64,"height":48,"seed":)" + std::to_string(turn) + more +
         R"(,"scene":{"title":")" + std::to_string(turn) + "\"," + scene + "}}";
}

const std::string heart = R"({"type":"heart"})";
const std::string lamp =
    R"("lights":[{"type":"sphere","position":[4,6,-3],"radius":1,"samples":256}])";

std::string tiny_picture() {
  Host own;
  return own.get("/render?width=8&height=6").body;
}

// A recipe of so many bytes that unpacks to millions.
std::string bomb(const std::string& text) { return with_recipe(tiny_picture(), text); }

// A mirrored hall between two planes, seen down to the last reflection.
std::string hall() {
  const std::string mirror = R"("material":{"reflection":0.9}})";
  return R"("objects":[{"type":"plane","name":")" + std::string(256, 'a') +
         R"(","point":[0,0,-1],"normal":[0,0,1],)" + mirror + R"(,{"type":"plane","name":")" +
         std::string(256, 'b') + R"(","point":[0,0,1],"normal":[0,0,-1],)" + mirror +
         R"(],"lights":)" + listed(400, R"({"type":"point","position":[0,0,0]})");
}

// A scene by a title of its own.
std::string titled(int turn, const std::string& rest) {
  return R"({"title":")" + std::to_string(turn) + "\"," + rest + "}";
}

// A key whose patch is as long as what it changes.
std::string with_patch(std::size_t hearts) {
  return R"("objects":)" + listed(hearts, heart) + R"(,"keys":{"p":{"objects":)" +
         listed(hearts, R"({"type":"clebsch"})") + "}}";
}

std::string mesh(std::size_t triangles) {
  return R"("objects":[{"type":"mesh","positions":[0,0,-9,1,0,-9,0,1,-9],"indices":)" +
         listed(triangles, "0,1,2") + "}]";
}

std::string image_scene() {
  std::string rows;
  for (int y = 0; y < 4096; ++y) rows += std::string(1 + 4096 * 3, '\0');
  std::string header("\0\0\x10\0\0\0\x10\0\x08\x02\0\0\0", 13);
  const std::string png = std::string("\x89PNG\r\n\x1A\n") + png_chunk("IHDR", header) +
                          png_chunk("IDAT", zlib(rows)) + png_chunk("IEND", "");
  return R"("objects":[{"type":"sphere","center":[0,0,-9],"radius":3,"material":{"texture":)"
         R"({"type":"image","data":")" +
         base64(png) + "\"}}}]";
}

// As many cells as intervals can be made to part bounds into.
std::string formula_scene(int turn) {
  return R"("objects":[{"type":"implicit","f":"sin(40*x)*sin(40*y)+sin(40*z)*sin(40*x*y)+0.0)" +
         std::to_string(turn) +
         R"(","bounds":{"min":[-9,-9,-9],"max":[9,9,9]}}],"camera":{"location":[0,0,30]})";
}

}  // namespace

std::vector<Attack> attacks() {
  const std::string bomb_of_hearts =
      bomb(R"({"version":"0.4.2","request":{"scene":{"objects":)" + listed(240'000, heart) + "}}}");
  const std::string bomb_of_lists = bomb(listed(20'000'000, "[]"));
  const std::string long_names = "{\"" + std::string(200'000, 'n') + "\":1,\"scene\":{\"" +
                                 std::string(2'000'000, 'm') + "\":" + std::string(60'000, '7') +
                                 "}}";
  std::string many_faults =
      "{\"scene\":{\"objects\":" + listed(90'000, "{\"type\":\"spher\"}") + "}}";
  const std::string text_of_values = listed(2'000'000, "1");
  const std::string picture_of_zeros = tiny_picture() + std::string(40 << 20, '\0');
  const std::string image = image_scene(), mirrors = hall(), triangles = mesh(650'000),
                    patched = with_patch(40'000), hearts = R"("objects":)" + listed(20'000, heart);
  const auto number = [](int turn) { return std::to_string(turn); };
  return {
      {"RecipeOfHearts",
       [=](Asker& a, int turn) {
         a.ask("POST", turn % 2 == 0 ? "/render" : "/verify", bomb_of_hearts, seconds(30),
               "image/png");
       }},
      {"RecipeOfLists",
       [=](Asker& a, int) { a.ask("POST", "/verify", bomb_of_lists, seconds(30), "image/png"); }},
      {"LongNames", [=](Asker& a, int) { a.ask("POST", "/render", long_names); }},
      {"ManyFaults", [=](Asker& a, int) { a.ask("POST", "/render", many_faults); }},
      {"ManyValues", [=](Asker& a, int) { a.ask("POST", "/scenes", text_of_values); }},
      {"Explanations",
       [=](Asker& a, int turn) {
         a.ask("POST", "/explain", drawn(mirrors, turn, R"(,"x":1,"y":1,"max_depth":64)"));
       }},
      {"Patches",
       [=](Asker& a, int turn) {
         if (a.ask("POST", "/scenes", titled(turn, patched)) != 201) return;
         const std::string id = text_at(parse_json(a.body()), "id");
         for (int i = 0; i < 8; ++i)
           a.ask("GET", "/render?width=32&height=24&key=p&seed=" + number(i) + "&scene=" + id);
       }},
      {"HiddenCosts",
       [=](Asker& a, int turn) {
         a.ask("POST", "/render",
               R"({"seed":)" + number(turn) + R"(,"width":1400,"height":1400,"scene":{
             "objects":[{"type":"plane","point":[0,-1,0],"normal":[0,1,0]}],)" +
                   lamp + "}}");
       }},
      {"Leavers",
       [=](Asker& a, int turn) {
         a.ask("GET", "/render?width=2000&height=2000&samples=4&seed=" + number(turn), "",
               milliseconds(50));
       }},
      {"Posters",
       [=](Asker& a, int turn) {
         a.ask("GET", "/render?width=4096&height=4096&seed=" + number(turn) +
                          (turn % 2 == 0 ? "&format=pfm" : ""));
       }},
      {"Meshes", [=](Asker& a, int turn) { a.ask("POST", "/render", drawn(triangles, turn)); }},
      {"Images", [=](Asker& a, int turn) { a.ask("POST", "/render", drawn(image, turn)); }},
      {"Formulas",
       [=](Asker& a, int turn) { a.ask("POST", "/render", drawn(formula_scene(turn), turn)); }},
      {"KeptScenes",
       [=](Asker& a, int turn) { a.ask("POST", "/scenes", titled(turn % 100, hearts)); }},
      {"PicturesSentBack",
       [=](Asker& a, int) {
         a.ask("POST", "/verify", picture_of_zeros, seconds(30), "image/png");
       }},
  };
}

// ---- all at once ----------------------------------------------------------------------------

Siege::Siege(int port, std::vector<Attack> attacks)
    : attacks_(std::move(attacks)), turns_(attacks_.size()) {
  for (std::size_t i = 0; i < attacks_.size(); ++i)
    attackers_.emplace_back([this, i, port] {
      Asker asker(port, "10.0.1." + std::to_string(i + 1));
      while (!over_) attacks_[i].act(asker, turns_[i]++);
    });
}
Siege::~Siege() { over_ = true; }

std::vector<int> Siege::turns() const { return {turns_.begin(), turns_.end()}; }

}  // namespace tia::test
