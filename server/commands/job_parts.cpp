#include "server/commands/job_parts.h"

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "core/input/json.h"
#include "core/version.h"
#include "core/video/stored_zip.h"
#include "server/commands/files.h"
#include "server/commands/picture_file.h"
#include "server/jobs/drawing.h"
#include "server/requests/recipe.h"

namespace tia::server {
namespace {

// Of one size whatever the machine has: parts of several go together.
constexpr int window_px = 256;

/// JobShop: what a job's parts need of their host where there is no server.
class JobShop {
 public:
  JobShop(const std::string& file, const Config& config)
      : workshop_(config), host_{context(config), costs_, window_px} {
    const JobRequest asked =
        read_job_request(parse_json(read_file(file), config.json_limits()), {});
    const JobKind& kind = job_kind(asked.terms.kind);
    JobPlan plan = kind.plan(asked, host_, {});
    job_.kind = asked.terms.kind;
    job_.request = std::move(plan.request);
    job_.plan = std::move(plan.plan);
    job_.parts = plan.parts;
    job_.joins = plan.joins;
    parts_ = kind.open(job_, host_, {});
  }
  int count() const { return job_.parts; }
  bool joins() const { return job_.joins; }
  Picture draw_part(int n) {
    const PictureRequest asked = parts_->part(n);
    Plan plan = plan_of(asked, host_.context, {});
    plan.takes_codes = parts_->are_pieces();
    return draw(plan, host_.context, {});
  }
  std::string joined(const JobParts::Piece& piece) {
    const PictureRequest asked = parts_->whole();
    const Plan plan = plan_of(asked, host_.context, {});
    return parts_->join(plan, piece, {}).bytes;
  }
  std::string name_of_part(int n) const {
    std::string number = std::to_string(n);
    number.insert(0, 5 - std::min(number.size(), std::size_t{5}), '0');
    return number + "." + std::string(name_of(parts_->part(n).format));
  }

 private:
  RenderContext context(const Config& config) {
    RenderContext own = workshop_.context();
    own.limits.max_rays = config.max_job_rays;
    return own;
  }
  Workshop workshop_;
  CostMemory costs_;
  JobHost host_;
  Job job_;
  std::unique_ptr<JobParts> parts_;
};

std::string part_file(const std::string& folder, int n) {
  return folder + "/" + std::to_string(n) + ".part";
}

// Errors: std::invalid_argument naming the variable.
int part_from(const std::string& variable, std::string_view text) {
  int part = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), part);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::invalid_argument(variable + ": got " + std::string(text) +
                                ", allowed: a part's number");
  return part;
}

}  // namespace

void draw_job_part(const std::string& file, std::optional<int> part, const std::string& folder,
                   const Config& config) {
  JobShop shop(file, config);
  if (!part) {
    std::cout << shop.count() << std::endl;
    return;
  }
  if (*part < 0 || *part >= shop.count())
    throw std::invalid_argument("option --part: got " + std::to_string(*part) + ", allowed: 0 to " +
                                std::to_string(shop.count() - 1));
  replace_file(part_file(folder, *part), shop.draw_part(*part).bytes);
}

std::optional<int> part_of_environment() {
  for (const char* name : {"SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX"})
    if (const char* text = std::getenv(name)) return part_from(name, text);
  return std::nullopt;
}

void join_job(const std::string& file, const std::string& folder, const std::string& output,
              const Config& config) {
  JobShop shop(file, config);
  const auto piece = [&](int n) { return read_file(part_file(folder, n)); };
  if (shop.joins()) return write_file(output, shop.joined(piece));
  if (shop.count() == 1) return write_file(output, piece(0));
  StoredZip zip;
  FileToBe archive(output);
  for (int n = 0; n < shop.count(); ++n) archive.append(zip.file(shop.name_of_part(n), piece(n)));
  archive.append(zip.end());
  archive.finish();
}

}  // namespace tia::server
