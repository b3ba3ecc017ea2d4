// Every option of the server in one table: flag, environment variable, range, default, meaning.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/codec.h"
#include "core/scene/limits.h"

namespace tia::server {

/// Config. A field `max_pixels` is the flag --max-pixels and the environment variable
/// TIA_MAX_PIXELS; the flag wins.
struct Config {
  std::string host = "127.0.0.1";
  int port = 8080;
  int threads = processors();
  std::int64_t max_body_bytes = 4 << 20;
  std::int64_t max_scenes_bytes = 64 << 20;
  std::int64_t max_pixels = Limits{}.max_pixels;
  std::int64_t max_rays = Limits{}.max_rays;
  std::int64_t max_work = Limits{}.max_work;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("host", &Config::host, Spec{.about = "address to listen on; 0.0.0.0 = every one"});
    visit("port", &Config::port,
          Spec{.about = "port to listen on; 0 = any free one", .min = 0, .max = 65535});
    visit("threads", &Config::threads,
          Spec{.about = "threads that trace (default: the processors)", .min = 1, .max = 64});
    visit("max_body_bytes", &Config::max_body_bytes,
          Spec{.about = "largest request body", .unit = "bytes", .min = 1024, .max = 1 << 30});
    visit("max_scenes_bytes", &Config::max_scenes_bytes,
          Spec{.about = "memory for the scenes that POST /scenes keeps",
               .unit = "bytes",
               .min = 0,
               .max = 1LL << 40U});
    visit("max_pixels", &Config::max_pixels,
          Spec{.about = "largest picture", .unit = "pixels", .min = 1, .max = 1 << 28});
    visit("max_rays", &Config::max_rays,
          Spec{.about = "most rays of all kinds that a picture may take",
               .unit = "rays",
               .min = 1,
               .max = 1e15});
    visit("max_work", &Config::max_work,
          Spec{.about = "most tests of rays against boxes and surfaces that a picture may take",
               .unit = "tests",
               .min = 1,
               .max = 1e15});
  }

  /// An empty host.
  void check(const Place& at, Faults& faults) const;
  /// What one request may ask for.
  Limits limits() const { return {max_pixels, max_rays, max_work}; }

  /// Processors that this process may use, at most 64.
  static int processors();
};

/// "max_pixels" as --max-pixels.
std::string flag_of(std::string_view name);

/// An option as the command line and the documents need it.
struct OptionRow {
  std::string name, flag, variable, about, allowed, default_text;
};

/// The table's rows, in order.
std::vector<OptionRow> option_rows();

/// A setting as text: the option's name and what was given.
struct Setting {
  std::string name, text, source;  ///< source: the flag or variable that gave it
};

/// Errors: std::invalid_argument naming the source, what came and what is allowed.
Config read_config(const std::vector<Setting>& settings);

/// The settings that the environment gives.
std::vector<Setting> environment_settings();

}  // namespace tia::server
