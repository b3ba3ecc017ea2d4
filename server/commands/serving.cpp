#include "server/commands/serving.h"

#include <pthread.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
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
#include "server/contract/problem.h"
#include "server/handlers/backend.h"
#include "server/handlers/dispatch.h"
#include "server/http/http_server.h"
#include "server/jobs/farm.h"
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

// Waits for one of them, or for what it asks for every now and then. Returns: the signal, or 0.
int wait_for(const sigset_t& signals, const std::function<bool()>& is_over) {
  constexpr timespec now_and_then{.tv_sec = 0, .tv_nsec = 200'000'000};
  while (!is_over())
    if (const int signal = sigtimedwait(&signals, nullptr, &now_and_then); signal > 0)
      return signal;
  return 0;
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

// All that a worker answers.
Response answer_as_worker(const Request& request, const RedisJobs& farm, Service& service) {
  constexpr std::array<std::string_view, 4> answered{"/healthz", "/readyz", "/metrics", "/version"};
  if (std::count(answered.begin(), answered.end(), request.path()) == 0)
    return refusal(failure("not-found", "a worker answers /healthz, /readyz, /metrics, /version"),
                   request, service);
  if (request.path() == "/readyz" && !farm.is_up())
    return refusal(std::make_exception_ptr(StorageAway("the farm's Redis does not answer")),
                   request, service);
  return answer(request, service);
}

Application worker_application(const RedisJobs& farm, Service& service) {
  Application as_worker = application(service);
  as_worker.answer = [&](const Request& request) {
    return answer_as_worker(request, farm, service);
  };
  as_worker.from_memory = [](const Request&) { return std::nullopt; };
  as_worker.long_body = [](const Request&) { return nullptr; };
  return as_worker;
}

// What it is at may end; what has not by then is given back.
void end_work(RedisJobs& farm, milliseconds limit) {
  const auto until = std::chrono::steady_clock::now() + limit;
  farm.rest();
  while (farm.held() > 0 && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(milliseconds(10));
}

// `farm`: of a worker, the store that the files have; of who serves null.
void serve_until_told(const Config& config, DataFiles files, RedisJobs* farm) {
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
  Backend backend(config, gallery, std::move(files));
  Service& service = backend.service;
  HttpServer server(http_options(config),
                    farm == nullptr ? application(service) : worker_application(*farm, service));
  service.connections = [&] { return server.connections(); };
  backend.memory.add(MemoryAccount::program,
                     addresses_beyond(config.memory_bytes, backend.pool.most_more_threads() *
                                                               std::int64_t{stack_bytes}));

  const Log log;
  std::jthread listening([&] { server.run(); });
  std::printf("Tia %s listening on http://%s:%d\n", version().c_str(), in_url(config.host).c_str(),
              server.port());
  std::fflush(stdout);
  const auto is_over = [&] { return farm != nullptr && farm->is_banned(); };
  while (wait_for(signals, is_over) == SIGHUP) reload(backend.access);
  std::signal(SIGHUP, config.keys_file.empty() ? SIG_DFL : SIG_IGN);
  for (const int impatience : {SIGTERM, SIGINT})
    std::signal(impatience, [](int number) { std::_Exit(128 + number); });
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  service.draining = true;
  if (farm != nullptr) end_work(*farm, milliseconds(config.drain_ms));
  server.stop(milliseconds(config.drain_delay_ms), milliseconds(config.drain_ms));
  listening.join();
}

}  // namespace

void serve(const Config& config) try {
  serve_until_told(config,
                   {scene_file(config), model_folder(config), job_store(config), quotas_of(config)},
                   nullptr);
} catch (const std::system_error& error) {
  if (error.code() != std::errc::resource_unavailable_try_again) throw;
  throw std::runtime_error(
      std::string("no room for all threads (options TIA_THREADS, TIA_RENDERS, TIA_QUEUE): ") +
      error.what());
}

void work(Config config, const std::string& name) {
  if (config.farm.empty()) throw std::invalid_argument("option TIA_FARM: a worker needs a farm");
  // One part at a time, by all threads; and who asks whether it lives.
  config.renders = 1, config.queue = 0, config.streams = 0, config.connections = 16;
  auto jobs = farm_jobs(config, job_limits(config, true), FarmRole::draws, name);
  RedisJobs& farm = *jobs;
  serve_until_told(config, {nullptr, nullptr, std::move(jobs)}, &farm);
}

bool is_healthy(const Config& config) {
  return answers(reachable(config.host), config.port, "/healthz");
}

}  // namespace tia::server
