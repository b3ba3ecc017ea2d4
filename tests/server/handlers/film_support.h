// What tests of films share: a scene that moves, and films asked for over a socket.
#pragma once

#include <string>

#include "tests/server/handlers/streams_support.h"

namespace tia::test {

// Eight frames: a light that goes over and, from the fifth on, stays.
inline const std::string moving_lamp = R"({"animation":{"duration":1,"fps":8,"tracks":[
    {"target":"/key_light/position","keys":[[0,[-9,9,0]],[0.5,[9,9,0]]]}]},
  "objects":[{"type":"sphere","center":[0,0,-9],"radius":2,"material":{"color":[1,0.5,0.2]}}]})";

inline std::string film_body(const std::string& more, const std::string& scene = moving_lamp) {
  const bool has_size = more.find("\"width\"") != more.npos;
  return (has_size ? "{" : R"({"width":24,"height":18,)") + more + R"("scene":)" + scene + "}";
}

inline Response post_film(int port, const std::string& body) {
  return test::exchange(port, "POST /film HTTP/1.1\r\nHost: x\r\nContent-Length: " +
                                  std::to_string(body.size()) + "\r\n\r\n" + body);
}

/// The film that is there. The test fails where there is none.
inline Response film(const std::string& more, const std::string& scene = moving_lamp) {
  Response response = post_film(shared_server().port(), film_body(more, scene));
  EXPECT_EQ(response.status, 200) << response.body;
  return response;
}

/// Frame k as /render has it.
inline Response frame_of(int k, const std::string& more = "") {
  return host().post("/render", film_body(more + R"("frame":)" + std::to_string(k) + ","));
}

}  // namespace tia::test
