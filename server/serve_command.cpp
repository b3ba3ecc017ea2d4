#include "server/serve_command.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "core/version.h"
#include "server/access/sites.h"
#include "server/handlers/backend.h"
#include "server/handlers/dispatch.h"
#include "server/http/http_server.h"
#include "server/operation/log.h"

namespace tia::server {
namespace {

using std::chrono::milliseconds;

// Requests that are read, or find what they want in a store; and of clients that ask for little,
// whatever others do.
constexpr int without_ticket = 8;

// Buffers of an ordinary picture stay warm in the heap (fresh pages would cost it a tenth of its
// time); those of a poster go back to the system, and so does what a rush of requests left. Of
// little memory less stays: ten minutes of siege on 512 MiB left 130 MiB of holes between pieces of
// up to 2 MiB.
void bound_idle_memory(std::int64_t memory_bytes) {
#if defined(__GLIBC__)
  constexpr std::int64_t megabyte = 1 << 20;
  mallopt(M_ARENA_MAX, 1);  // each further one reserves 64 MiB of addresses
  mallopt(M_MMAP_THRESHOLD,
          static_cast<int>(std::clamp(memory_bytes / 1024, megabyte / 4, 2 * megabyte)));
  mallopt(M_TRIM_THRESHOLD, 4 * megabyte);
#endif
}

// Threads' stacks: the deepest scenes and trees take less than half a MiB. The usual 8 MiB of some
// ninety threads would be more addresses than small machines allow.
constexpr int stack_bytes = 1 << 20;
void bound_stacks() {
#if defined(__GLIBC__) && !defined(TIA_SANITIZED)
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return;
  pthread_attr_setstacksize(&attributes, stack_bytes);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
#endif
}

void give_memory_back() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

// What is told of keys at the start.
void warn_of_keys(const Config& config) {
  if (config.keys_file.empty() || is_loopback(config.host) || !config.trusted_proxies.empty())
    return;
  std::fputs(
      "tia: keys come from other machines in the clear: put a proxy before the server that speaks "
      "TLS, and name it in TIA_TRUSTED_PROXIES\n",
      stderr);
}

// What goes wrong is told, and changes nothing.
void reload(Access& access) {
  try {
    access.reload();
    log_event("the keys have been read anew");
  } catch (const std::exception& error) {
    log_event(std::string("the keys stay as they were: ") + error.what());
  }
}

// RFC 3986, 3.2.2: an IPv6 address stands in brackets.
std::string in_url(const std::string& host) {
  return host.find(':') == host.npos ? host : '[' + host + ']';
}

// Where a server that listens on every address of this machine can be asked.
std::string reachable(const std::string& host) {
  return host == "0.0.0.0" ? "127.0.0.1" : host == "::" ? "::1" : host;
}

int wait_for(const sigset_t& signals) {
  int signal = 0;
  sigwait(&signals, &signal);
  return signal;
}

HttpOptions http_options(const Config& config) {
  HttpOptions options{.host = config.host, .port = config.port};
  options.max_body_bytes = config.max_body_bytes;
  options.max_png_bytes = config.max_png_bytes;
  options.connections = config.connections;
  // One for each request that may be worked at or wait, which tickets bound, some for requests
  // that need no ticket, and one for each live stream.
  options.workers = config.queue + 2 * config.renders + without_ticket + config.streams;
  options.spare_workers = without_ticket;
  options.share_of = share_of;
  options.deadline = milliseconds(config.deadline_ms);
  // A quarter of the memory, of which the largest picture that is sent back may take a half.
  options.most_held_bytes = static_cast<std::size_t>(config.memory_bytes / 4);
  options.trusts_proxy = [&config](const std::string& address) {
    const auto& trusted = config.trusted_proxies;
    return std::any_of(trusted.begin(), trusted.end(),
                       [&](const Network& network) { return network.contains(address); });
  };
  return options;
}

Application application(Service& service) {
  return {
      .answer = [&](const Request& request) { return answer(request, service); },
      .refuse = [&](const std::exception_ptr& failure,
                    const Request& request) { return refusal(failure, request, service); },
      .identify = [&](Request& request) { service.access.identify(request); },
      .at_once = is_answered_at_once,
      .from_memory = [&](const Request& request) { return answer_from_memory(request, service); },
      .body_limit = [&](const Request& request) { return body_limit(request, service.config); },
      .long_body = [&](const Request& request) { return long_body(request, service); },
      .retry_after = [&] { return service.admission.retry_after(); },
      .rested = give_memory_back,
      .held = [&](std::ptrdiff_t bytes) { service.memory.add(MemoryAccount::connections, bytes); },
      .answered =
          [&](const Exchange& exchange) {
            service.metrics.count(exchange, route_label(exchange.request));
            log_exchange(exchange);
          }};
}

std::unique_ptr<SceneFile> scene_file(const Config& config) {
  if (config.data_dir.empty()) return nullptr;
  return std::make_unique<SceneFile>(config.data_dir, config.max_data_bytes);
}
std::unique_ptr<ModelFolder> model_folder(const Config& config) {
  if (config.data_dir.empty()) return nullptr;
  return std::make_unique<ModelFolder>(config.data_dir, config.max_data_bytes);
}

void serve_until_told(const Config& config) {
  bound_idle_memory(config.memory_bytes);
  bound_stacks();
  // Blocked in every thread, so that one can wait for them.
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  if (!config.keys_file.empty()) sigaddset(&signals, SIGHUP);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);

  warn_of_keys(config);
  const Gallery gallery;
  Backend backend(config, gallery, {scene_file(config), model_folder(config), job_store(config)});
  Service& service = backend.service;
  HttpServer server(http_options(config), application(service));
  service.connections = [&] { return server.connections(); };
  backend.memory.add(MemoryAccount::program,
                     addresses_beyond(config.memory_bytes, backend.pool.most_more_threads() *
                                                               std::int64_t{stack_bytes}));

  const Log log;
  std::jthread listening([&] { server.run(); });
  std::printf("Tia %s listening on http://%s:%d\n", version().c_str(), in_url(config.host).c_str(),
              server.port());
  std::fflush(stdout);
  while (wait_for(signals) == SIGHUP) reload(backend.access);
  std::signal(SIGHUP, config.keys_file.empty() ? SIG_DFL : SIG_IGN);
  for (const int impatience : {SIGTERM, SIGINT})
    std::signal(impatience, [](int number) { std::_Exit(128 + number); });
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  service.draining = true;
  server.stop(milliseconds(config.drain_delay_ms), milliseconds(config.drain_ms));
  listening.join();
}

}  // namespace

void serve(const Config& config) try {
  serve_until_told(config);
} catch (const std::system_error& error) {
  if (error.code() != std::errc::resource_unavailable_try_again) throw;
  throw std::runtime_error(
      std::string("no room for all threads (options TIA_THREADS, TIA_RENDERS, TIA_QUEUE): ") +
      error.what());
}

bool is_healthy(const Config& config) {
  return answers(reachable(config.host), config.port, "/healthz");
}

}  // namespace tia::server
