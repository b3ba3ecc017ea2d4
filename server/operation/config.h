// Every option of the server in one table: flag, environment variable, range, default, meaning.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/codec.h"
#include "core/models/model_files.h"
#include "core/scene/limits.h"
#include "server/http/peers.h"
#include "server/operation/memory_account.h"

namespace tia::server {

/// Config. A field `max_pixels` is the flag --max-pixels and the environment variable
/// TIA_MAX_PIXELS; the flag wins.
struct Config {
  static constexpr double hour_ms = 3'600'000;
  std::string host = "127.0.0.1";
  int port = 8080;
  int threads = processors();
  int renders = 8;
  int queue = 64;
  int connections = 1024;
  int deadline_ms = 30'000;
  std::int64_t memory_bytes = usual_memory_bytes();
  int drain_ms = 9'000;  // docker kills after 10 s
  int drain_delay_ms = 0;
  std::int64_t max_body_bytes = 4 << 20;
  std::int64_t max_png_bytes = 64 << 20;
  int max_nodes = 100'000;
  std::int64_t max_scenes_bytes = 64 << 20;
  std::int64_t max_geometry_bytes = 256 << 20;
  std::int64_t cache_bytes = 256 << 20;
  std::int64_t scene_keep_s = 0;
  std::string data_dir;
  std::int64_t max_data_bytes = 1 << 30;
  std::int64_t max_model_bytes = 64 << 20;
  std::int64_t max_models_bytes = 256 << 20;
  std::int64_t max_triangles = 8'388'608;
  std::int64_t max_texture_pixels = 100'663'296;
  std::int64_t model_memory_bytes = 2LL << 30U;
  std::int64_t max_pixels = Limits{}.max_pixels;
  std::int64_t max_rays = Limits{}.max_rays;
  std::int64_t max_work = Limits{}.max_work;
  std::int64_t max_events = Limits{}.max_events;
  int max_frames = Limits{}.max_frames;
  int film_deadline_ms = 600'000;
  int streams = 32;
  std::string ffmpeg;
  std::int64_t max_job_rays = 1'000'000'000'000;
  int max_jobs = 1000;
  std::int64_t max_jobs_bytes = 1 << 30;
  std::int64_t job_keep_s = 86'400;
  int job_tries = 5;
  std::vector<Origin> cors_origins;
  std::vector<Network> trusted_proxies;
  std::vector<HostName> hosts;
  std::string keys_file, sign_file;
  std::string farm;
  std::string farm_password_file;
  std::string farm_ca_file;
  int farm_lease_ms = 15'000;
  double farm_audit = 0.01;
  std::string store;
  std::string s3_endpoint;
  std::string s3_region = "us-east-1";
  std::string s3_key_file;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("host", &Config::host, Spec{.about = "address to listen on; 0.0.0.0 = every one"});
    visit("port", &Config::port,
          Spec{.about = "port to listen on; 0 = any free one", .min = 0, .max = 65535});
    visit("threads", &Config::threads,
          Spec{.about = "threads that trace (default: the processors)", .min = 1, .max = 64});
    visit("renders", &Config::renders,
          Spec{.about = "pictures that may be drawn at once", .min = 1, .max = 64});
    visit("queue", &Config::queue,
          Spec{.about = "requests that may wait to be drawn", .min = 0, .max = 1024});
    visit("connections", &Config::connections,
          Spec{.about = "connections that may be open", .min = 8, .max = 65536});
    visit("memory_bytes", &Config::memory_bytes,
          Spec{.about = "memory that the server may take in all; requests that need more wait or "
                        "are refused (default: three quarters of the control group's limit, of "
                        "RLIMIT_AS or of the machine's memory, at least 256 MiB)",
               .unit = "bytes",
               .min = 256 << 20,
               .max = 1LL << 50U});
    visit("deadline_ms", &Config::deadline_ms,
          Spec{.about = "what a request may take, its wait included; beyond it 503",
               .unit = "ms",
               .min = 1,
               .max = hour_ms});
    visit("drain_ms", &Config::drain_ms,
          Spec{.about = "what requests may still take after SIGTERM before they are given up",
               .unit = "ms",
               .min = 0,
               .max = 600'000});
    visit("drain_delay_ms", &Config::drain_delay_ms,
          Spec{.about = "how long after SIGTERM new requests are taken, /readyz being 503, so that "
                        "balancers notice",
               .unit = "ms",
               .min = 0,
               .max = 600'000});
    visit("max_body_bytes", &Config::max_body_bytes,
          Spec{.about = "largest request body", .unit = "bytes", .min = 1024, .max = 1 << 30});
    visit("max_png_bytes", &Config::max_png_bytes,
          Spec{.about = "largest picture that is sent back, as a body of type image/png",
               .unit = "bytes",
               .min = 1024,
               .max = 1 << 30});
    visit("max_nodes", &Config::max_nodes,
          Spec{.about = "most JSON values in a text, numbers inside arrays not counted",
               .unit = "values",
               .min = 4096,  // what a URL can hold
               .max = 1e9});
    visit("max_scenes_bytes", &Config::max_scenes_bytes,
          Spec{.about = "memory for the scenes that POST /scenes keeps",
               .unit = "bytes",
               .min = 0,
               .max = 1LL << 40U});
    visit("max_geometry_bytes", &Config::max_geometry_bytes,
          Spec{.about = "memory for compiled scenes, which pictures of the same objects share; 0 = "
                        "each compiles its own",
               .unit = "bytes",
               .min = 0,
               .max = 1LL << 40U});
    visit("cache_bytes", &Config::cache_bytes,
          Spec{.about = "memory for pictures that have been drawn; 0 = each is drawn anew",
               .unit = "bytes",
               .min = 0,
               .max = 1LL << 40U});
    visit("scene_keep_s", &Config::scene_keep_s,
          Spec{.about = "how long a kept scene is kept that nobody uses; 0 = for ever",
               .unit = "s",
               .min = 0,
               .max = 1e9});
    visit("data_dir", &Config::data_dir,
          Spec{.about = "folder for the scenes and models that clients send, and for jobs, so that "
                        "they outlive the server; none = they are kept in memory only"});
    visit("max_data_bytes", &Config::max_data_bytes,
          Spec{.about = "what the file of kept scenes may hold, and the models beside it; beyond "
                        "it none is kept any more",
               .unit = "bytes",
               .min = 1 << 20,
               .max = 1LL << 40U});
    visit("max_model_bytes", &Config::max_model_bytes,
          Spec{.about = "largest model that is sent; unpacked it may have four times as much",
               .unit = "bytes",
               .min = 1024,
               .max = 1 << 30});
    visit("max_models_bytes", &Config::max_models_bytes,
          Spec{.about = "memory for the models that POST /models keeps where TIA_DATA_DIR names no "
                        "folder; and as much for what was read of models",
               .unit = "bytes",
               .min = 0,
               .max = 1LL << 40U});
    visit("max_triangles", &Config::max_triangles,
          Spec{.about = "most triangles of a model; a mesh that it shows several times counts once",
               .unit = "triangles",
               .min = 1,
               .max = 1 << 28});
    visit("max_texture_pixels", &Config::max_texture_pixels,
          Spec{.about = "most pixels of all textures of a model",
               .unit = "pixels",
               .min = 1,
               .max = 1LL << 32U});
    visit("model_memory_bytes", &Config::model_memory_bytes,
          Spec{.about = "memory of the process that reads a model, beside that of the server",
               .unit = "bytes",
               .min = 128 << 20,
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
    visit("max_events", &Config::max_events,
          Spec{.about = "most collisions of a motion, or, by rigid, most steps of all its bodies",
               .unit = "events",
               .min = 1,
               .max = 1e9});
    visit("max_frames", &Config::max_frames,
          Spec{.about = "most frames of a film; its rays together are at most a picture's",
               .unit = "frames",
               .min = 1,
               .max = 100'000});
    visit("film_deadline_ms", &Config::film_deadline_ms,
          Spec{.about = "what a film may take instead, from its request on; beyond it the film is "
                        "cut, which its reader sees",
               .unit = "ms",
               .min = 1,
               .max = 24 * hour_ms});
    visit("streams", &Config::streams,
          Spec{.about = "live streams that may be open at once, of one client a quarter; each may "
                        "last as long as a film",
               .min = 0,
               .max = 1024});
    visit("ffmpeg", &Config::ffmpeg,
          Spec{.about = "the program ffmpeg, such as /usr/bin/ffmpeg, by which films become mp4: a "
                        "process of its own, with 2 GiB of memory beside that of the server; none: "
                        "there is no mp4"});
    visit("max_job_rays", &Config::max_job_rays,
          Spec{.about = "most rays of all kinds that a job may take",
               .unit = "rays",
               .min = 1,
               .max = 1e15});
    visit("max_jobs", &Config::max_jobs,
          Spec{.about = "jobs that may be unfinished", .min = 0, .max = 100'000});
    visit("max_jobs_bytes", &Config::max_jobs_bytes,
          Spec{.about = "what jobs may hold, their requests and results; the results of those go "
                        "first that ended first. In memory, without TIA_DATA_DIR, at most an "
                        "eighth of TIA_MEMORY_BYTES",
               .unit = "bytes",
               .min = 1 << 20,
               .max = 1LL << 40U});
    visit("job_keep_s", &Config::job_keep_s,
          Spec{.about = "how long a job's results are kept after its end",
               .unit = "s",
               .min = 1,
               .max = 1e9});
    visit("job_tries", &Config::job_tries,
          Spec{.about = "how often a part of a job may end without a result before the job fails",
               .min = 1,
               .max = 1000});
    visit("farm", &Config::farm,
          Spec{.about = "Redis that keeps jobs, for all who serve and all workers, such as "
                        "rediss://tia@host:6379/0; none = jobs are this process' own"});
    visit("farm_password_file", &Config::farm_password_file,
          Spec{.about = "file with the password of TIA_FARM's user; none = it has none"});
    visit("farm_ca_file", &Config::farm_ca_file,
          Spec{.about = "file (PEM) of certificates that TIA_FARM's has to lead to; none = the "
                        "system's"});
    visit("farm_lease_ms", &Config::farm_lease_ms,
          Spec{.about = "how long a worker may not be heard of before its part is another's",
               .unit = "ms",
               .min = 100,
               .max = hour_ms});
    visit(
        "farm_audit", &Config::farm_audit,
        Spec{.about = "share of the parts that two workers draw, to compare", .min = 0, .max = 1});
    visit("store", &Config::store,
          Spec{.about = "where results of jobs are kept, and what a farm's jobs name that clients "
                        "have sent: dir:/path, a folder (of a farm one that all its machines "
                        "see), or s3://bucket/prefix; none = with the jobs"});
    visit("s3_endpoint", &Config::s3_endpoint,
          Spec{.about = "where S3 is, such as https://minio:9000; none = AWS' of TIA_S3_REGION"});
    visit("s3_region", &Config::s3_region,
          Spec{.about = "the region that requests to S3 are signed for"});
    visit("s3_key_file", &Config::s3_key_file,
          Spec{.about = "file of two lines, the id of the key for S3 and its secret; none = "
                        "requests are signed by an empty one"});
    visit("cors_origins", &Config::cors_origins,
          Spec{.about = "origins whose pages may read answers (CORS)"});
    visit("trusted_proxies", &Config::trusted_proxies,
          Spec{.about = "proxies whose word for a client's address is taken"});
    visit("hosts", &Config::hosts,
          Spec{.about = "names that requests may call the server by (Host), against DNS rebinding; "
                        "none: the loopback's where it listens there, else any"});
    visit("keys_file", &Config::keys_file,
          Spec{.about = "JSON file of keys, of what each may do and how much; none: anybody may do "
                        "anything but what is for admin"});
    visit("sign_file", &Config::sign_file,
          Spec{.about = "file of lines K HEX KEYID: by what URLs are signed, and whose rights "
                        "they then have; none: no URL is"});
  }

  /// An empty host.
  void check(const Place& at, Faults& faults) const;
  /// What one request may ask for.
  Limits limits() const { return {max_pixels, max_rays, max_work, max_events, max_frames}; }
  /// What is read of a model.
  ModelLimits model_limits() const;
  /// What a text may hold.
  JsonLimits json_limits() const { return {.values = static_cast<std::size_t>(max_nodes)}; }

  /// Processors that this process may use, at most 64.
  static int processors();
};

/// "max_pixels" as --max-pixels.
std::string flag_of(std::string_view name);

/// An option as the command line and the documents need it.
struct OptionRow {
  std::string name, flag, variable, about, allowed;
  std::string value;  ///< as a flag or variable would give it
};

/// The table's rows, in order, with the values of a configuration, the default one unless told.
std::vector<OptionRow> option_rows(const Config& config = {});

/// The configuration as a file of variables, each with a comment: what `docker run --env-file`
/// reads.
std::string env_file(const Config& config);

/// A setting as text: the option's name and what was given.
struct Setting {
  std::string name, text, source;  ///< source: the flag or variable that gave it
};

/// Errors: std::invalid_argument naming the source, what came and what is allowed.
Config read_config(const std::vector<Setting>& settings);

/// The settings that the environment gives.
std::vector<Setting> environment_settings();

/// The environment's variables TIA_… that are no option, each in a sentence with the nearest one
/// that is.
std::vector<std::string> unknown_variables();

}  // namespace tia::server
