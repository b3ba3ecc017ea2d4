// What tests of streams share: pictures by chance, streams taken apart, clients.
#pragma once

#include <string>
#include <vector>

#include "core/input/json.h"
#include "tests/core/png/png_reader.h"
#include "tests/server/http/parts_support.h"

namespace tia::test {

// A small room, lit by chance. Seeds make pictures that no other test has asked for.
inline std::string room(int seed, int samples, const std::string& more = "") {
  return "/render?scene=cornell-light&width=32&height=24&samples=" + std::to_string(samples) +
         "&seed=" + std::to_string(seed) + more;
}

// What is there without a stream, drawn by another server.
inline std::string plain_bytes(const std::string& target) {
  static Host apart;
  const Response drawn = apart.get(target);
  EXPECT_EQ(drawn.status, 200) << target;
  return drawn.body;
}

/// Event: one of a stream, taken apart.
struct Event {
  std::string name;
  Value data;
};

// Source: WHATWG HTML, 9.2.6, for what this server writes of it.
inline std::vector<Event> events_in(const std::string& body) {
  std::vector<Event> events;
  for (std::size_t from = 0, end; (end = body.find("\n\n", from)) != body.npos; from = end + 2) {
    const std::string each = body.substr(from, end - from);
    const std::size_t line = each.find('\n');
    EXPECT_THAT(each, testing::StartsWith("event: "));
    EXPECT_EQ(each.substr(line + 1, 6), "data: ");
    events.push_back({each.substr(7, line - 7), parse_json(each.substr(line + 7))});
  }
  return events;
}

/// StreamPart: one of a multipart body.
struct StreamPart {
  std::string head, picture;
};

// Source: RFC 2046, 5.1.1.
inline std::vector<StreamPart> stream_parts(const Response& response) {
  const std::string mark = "boundary=";
  const std::string line =
      "--" + response.content_type.substr(response.content_type.find(mark) + mark.size());
  std::vector<StreamPart> parts;
  std::string left = response.body;
  EXPECT_THAT(left, testing::StartsWith(line + "\r\n"));
  left.erase(0, line.size() + 2);
  while (!left.empty()) {
    const std::string head = left.substr(0, left.find("\r\n\r\n"));
    const std::string length = head.substr(head.find("Content-Length: ") + 16);
    EXPECT_THAT(left, testing::StartsWith("Content-Type: image/png\r\n"));
    parts.push_back({head, left.substr(head.size() + 4, std::stoul(length))});
    left.erase(0, head.size() + 4 + parts.back().picture.size());
    EXPECT_THAT(left, testing::StartsWith("\r\n" + line));
    left.erase(0, 2 + line.size());
    if (left == "--\r\n") break;
    left.erase(0, 2);
  }
  return parts;
}

inline std::vector<std::string> heads_in(const Response& response) {
  std::vector<std::string> heads;
  for (StreamPart& each : stream_parts(response)) heads.push_back(std::move(each.head));
  return heads;
}
inline std::vector<std::string> pictures_in(const Response& response) {
  std::vector<std::string> pictures;
  for (StreamPart& each : stream_parts(response)) pictures.push_back(std::move(each.picture));
  return pictures;
}

inline Response ask_on(int port, const std::string& target) {
  return test::exchange(port, "GET " + target + " HTTP/1.1\r\nHost: x\r\n\r\n");
}

inline Response posted_to(int port, const std::string& body) {
  return test::exchange(port, "POST /render HTTP/1.1\r\nHost: x\r\nContent-Length: " +
                                  std::to_string(body.size()) + "\r\n\r\n" + body);
}

// Sends it and reads as far as its first part.
inline std::string begun(Wire& wire, const std::string& target) {
  wire.get(target);
  return wire.until("\r\n\r\n") + wire.until("\n\n\r\n");
}

inline int at_work(Server& server) { return server.host().service().admission.at_work(); }

}  // namespace tia::test
