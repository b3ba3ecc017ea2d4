// Jobs of many pictures: a list of requests, or one request and a grid of what is put into it.
#include <algorithm>

#include "core/input/json.h"
#include "server/jobs/kinds.h"

namespace tia::server {
namespace {

constexpr int most_pictures = 100'000;

/// GridAxis: what is put where, one after the other.
struct GridAxis {
  std::string pointer;
  Value::Array values;
};
using Grid = std::vector<GridAxis>;

// RFC 6901, 4: the text of a pointer's token.
std::string unescaped(std::string_view token) {
  std::string text;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const bool escape = token[i] == '~' && i + 1 < token.size();
    if (escape) text += token[++i] == '1' ? '/' : '~';
    else text += token[i];
  }
  return text;
}
std::string escaped(std::string_view text) {
  std::string token;
  for (const char c : text) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

// The member or element of that name, or null; a new member of an object where it may be made.
Value* inside(Value& of, const std::string& name, bool makes) {
  if (auto* members = of.as<Value::Object>()) {
    for (auto& [key, value] : *members)
      if (key == name) return &value;
    return makes ? &members->emplace_back(name, Value()).second : nullptr;
  }
  auto* items = of.as<Value::Array>();
  const bool is_number = !name.empty() && name.size() < 10 &&
                         std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
  if (items == nullptr || !is_number) return nullptr;
  const auto i = static_cast<std::size_t>(std::stoul(name));
  return i < items->size() ? &(*items)[i] : nullptr;
}

// Puts it where the pointer leads: into what is there, or as a new member of it. Returns: whether
// there is such a place.
bool put_at(Value& into, std::string_view pointer, const Value& value) {
  Value* at = &into;
  while (!pointer.empty()) {
    if (pointer[0] != '/') return false;
    pointer.remove_prefix(1);
    const std::string_view token = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(token.size());
    at = inside(*at, unescaped(token), pointer.empty());
    if (at == nullptr) return false;
  }
  *at = value;
  return true;
}

// An object of pointers and lists, in the order of the text; or, as it is kept, a list of pairs.
Grid grid_of(const Value& value) {
  Grid grid;
  const auto refuse = [](const std::string& pointer, const Value& got, const char* allowed) {
    throw InputError({FaultKind::wrong_type, pointer, excerpt(got), allowed});
  };
  const auto add = [&](const std::string& pointer, const Value& list) {
    const auto* values = list.as<Value::Array>();
    if (values == nullptr || values->empty())
      refuse("/grid/" + escaped(pointer), list, "a list of what to put there, one after the other");
    else grid.push_back({pointer, *values});
  };
  if (const auto* members = value.as<Value::Object>()) {
    for (const auto& [pointer, list] : *members) add(pointer, list);
  } else if (const auto* pairs = value.as<Value::Array>()) {
    for (const Value& pair : *pairs)
      add(*(*pair.as<Value::Array>())[0].as<std::string>(), (*pair.as<Value::Array>())[1]);
  }
  if (grid.empty()) refuse("/grid", value, "an object of JSON Pointers into request, with lists");
  return grid;
}

int count_of(const Grid& grid) {
  double count = 1;
  for (const GridAxis& axis : grid) count *= static_cast<double>(axis.values.size());
  if (count > most_pictures)
    throw InputError({FaultKind::limit, "/grid", Value(number_text(count) + " pictures"),
                      "at most " + std::to_string(most_pictures) + " pictures"});
  return static_cast<int>(count);
}

// The last list fastest. Errors: InputError (out_of_range) for a pointer into nothing.
Value of_grid(const Value& base, const Grid& grid, int n) {
  Value request = base;
  std::vector<std::size_t> which(grid.size());
  auto left = static_cast<std::size_t>(n);
  for (std::size_t i = grid.size(); i-- > 0; left /= grid[i].values.size())
    which[i] = left % grid[i].values.size();
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (!put_at(request, grid[i].pointer, grid[i].values[which[i]]))
      throw InputError({FaultKind::out_of_range, "/grid/" + escaped(grid[i].pointer),
                        Value(grid[i].pointer), "a JSON Pointer to a place of request"});
  return request;
}

/// Pictures: the requests of a batch, in either form.
struct Pictures {
  Value::Array requests;
  Value base;
  Grid grid;

  int count() const { return grid.empty() ? static_cast<int>(requests.size()) : count_of(grid); }
  Value request(int n) const {
    return grid.empty() ? requests[static_cast<std::size_t>(n)] : of_grid(base, grid, n);
  }
  std::string place(int n) const {
    return grid.empty() ? "/requests/" + std::to_string(n) : "/request";
  }
};

Pictures pictures_of(const JobRequest& asked) {
  refuse_member(asked.views, "/views", "the kind turntable, which has them");
  Pictures pictures;
  if (asked.grid) {
    refuse_member(asked.requests, "/requests", "requests, or request with grid");
    pictures.base = needed(asked.request, "/request", "what the grid is put into");
    pictures.grid = grid_of(*asked.grid);
    return pictures;
  }
  refuse_member(asked.request, "/request", "request with grid, or requests");
  const Value& list = needed(asked.requests, "/requests", "a list of what POST /render takes");
  const auto* requests = list.as<Value::Array>();
  if (requests == nullptr || requests->empty())
    throw InputError({FaultKind::wrong_type, "/requests", excerpt(list),
                      "a list of what POST /render takes, not empty"});
  if (requests->size() > std::size_t{most_pictures})
    throw InputError({FaultKind::limit, "/requests",
                      Value(std::to_string(requests->size()) + " pictures"),
                      "at most " + std::to_string(most_pictures) + " pictures"});
  pictures.requests = *requests;
  return pictures;
}

std::string kept_text(const Pictures& pictures) {
  if (pictures.grid.empty()) return to_json(Value::Object{{"requests", pictures.requests}});
  Value::Array pairs;
  for (const GridAxis& axis : pictures.grid)
    pairs.push_back(Value::Array{axis.pointer, axis.values});
  return to_json(Value::Object{{"request", pictures.base}, {"grid", std::move(pairs)}});
}

// Whether their members are the same but for that one's value.
bool differ_alone_in(std::string_view name, const Value& one, const Value& other) {
  const auto *a = one.as<Value::Object>(), *b = other.as<Value::Object>();
  const auto is_same = [&](const auto& left, const auto& right) {
    return left.first == right.first && (left.first == name || left.second == right.second);
  };
  return a != nullptr && b != nullptr && std::ranges::equal(*a, *b, is_same);
}

/// RaysOfPictures: those of one after the other, all of whose faults are found.
class RaysOfPictures {
 public:
  RaysOfPictures(const JobHost& host, const Requester& requester)
      : context_(host.context), requester_(requester) {}

  // Errors: InputError; as plan_of.
  double of(Value request, const PictureRequest& picture) {
    if (!is_as_the_last(request, picture))
      rays_ = checked_plan_of(picture, context_, requester_).sure_rays();
    last_ = std::move(request);
    return rays_;
  }

 private:
  // The seed, once it is read, is at no fault, and decides no number of rays. Nor does a light,
  // once it is in its place: all that is planned of a scene that does not move is seen without it.
  bool is_as_the_last(const Value& request, const PictureRequest& picture) const {
    if (differ_alone_in("seed", request, last_)) return true;
    return differ_alone_in("light", request, last_) &&
           !found_scene(picture, context_, requester_).moving;
  }

  const RenderContext& context_;
  const Requester& requester_;
  Value last_;  // of which all has been checked, and its rays
  double rays_ = 0;
};

// All faults of all pictures, the first twenty.
JobPlan plan_batch(const JobRequest& asked, const JobHost& host, const Requester& requester) {
  const Pictures pictures = pictures_of(asked);
  Faults faults(requester.stop);
  JobPlan made;
  made.parts = pictures.count();
  RaysOfPictures rays(host, requester);
  for (int n = 0; n < made.parts && !faults.full(); ++n) try {
      end_if_asked(requester.stop);
      Value request = pictures.request(n);
      const PictureRequest picture = picture_at(request, pictures.place(n), host, requester);
      made.rays +=
          at_place(pictures.place(n), [&] { return rays.of(std::move(request), picture); });
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults())
        if (!faults.at(fault.pointer)) faults.add(fault);
    }
  faults.raise();
  made.request = kept_text(pictures);
  return made;
}

/// PicturesOfBatch: its parts.
class PicturesOfBatch : public JobParts {
 public:
  PicturesOfBatch(Pictures pictures, const JobHost& host)
      : pictures_(std::move(pictures)), host_(host) {}
  PictureRequest part(int n) const override {
    return picture_at(pictures_.request(n), pictures_.place(n), host_, {});
  }
  std::string place(int n) const override { return "\"frame\":" + std::to_string(n); }

 private:
  const Pictures pictures_;
  const JobHost& host_;
};

std::unique_ptr<JobParts> open_batch(const Job& job, const JobHost& host, const Requester&) {
  return std::make_unique<PicturesOfBatch>(pictures_of(asked_again(job)), host);
}

}  // namespace

const JobKind batch_job{"batch", plan_batch, open_batch};

}  // namespace tia::server
