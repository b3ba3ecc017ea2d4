#include "server/serve_command.h"

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <stop_token>
#include <thread>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "server/http/http_server.h"
#include "server/routes.h"

namespace tia::server {
namespace {

// Buffers of an ordinary picture stay warm in the heap (fresh pages would cost it a tenth of its
// time); those of a poster go back to the system, and so does what a rush of requests left.
void bound_idle_memory() {
#if defined(__GLIBC__)
  constexpr int megabyte = 1 << 20;
  mallopt(M_ARENA_MAX, 2);
  mallopt(M_MMAP_THRESHOLD, 4 * megabyte);
  mallopt(M_TRIM_THRESHOLD, 4 * megabyte);
#endif
}

// RFC 3986, 3.2.2: an IPv6 address stands in brackets.
std::string in_url(const std::string& host) {
  return host.find(':') == host.npos ? host : '[' + host + ']';
}

// Where a server that listens on every address of this machine can be asked.
std::string reachable(const std::string& host) {
  return host == "0.0.0.0" ? "127.0.0.1" : host == "::" ? "::1" : host;
}

// Renders that still run then are given up with a 503.
constexpr std::chrono::seconds drain_limit{20};

bool stopped_within(std::chrono::seconds time, const std::stop_token& stop) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  never.wait_for(lock, stop, time, [] { return false; });
  return stop.stop_requested();
}

int wait_for(const sigset_t& signals) {
  int signal = 0;
  sigwait(&signals, &signal);
  return signal;
}

}  // namespace

void serve(const Config& config) {
  bound_idle_memory();
  // Blocked in every thread, so that one can wait for them.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);

  const Gallery gallery;
  SceneStore kept(config.max_scenes_bytes);
  Pool pool(config.threads);
  std::stop_source giving_up;
  Service service{config, {gallery, kept, pool, config.limits()}, giving_up.get_token()};
  HttpServer server({config.host, config.port, config.max_body_bytes},
                    [&](const Request& request) { return answer(request, service); });
  std::printf("Tia %s listening on http://%s:%d\n", version().c_str(), in_url(config.host).c_str(),
              server.port());
  std::fflush(stdout);

  std::jthread listening([&] { server.run(); });
  wait_for(signals);
  std::thread([signals] { std::_Exit(128 + wait_for(signals)); }).detach();  // impatience
  server.stop();
  const std::jthread patience([&](const std::stop_token& drained) {
    if (!stopped_within(drain_limit, drained)) giving_up.request_stop();
  });
  listening.join();
}

bool is_healthy(const Config& config) {
  return answers(reachable(config.host), config.port, "/healthz");
}

}  // namespace tia::server
