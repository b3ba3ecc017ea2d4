// The thesis' tracer once more, as a textbook has it: one ray at a time, roots by the quadratic
// formula in long double, the camera by std::tan, nothing shared with the core but Scene and Vec3.
#pragma once

#include <algorithm>
#include <limits>

#include "tests/core/support.h"

namespace tia::test {

class Reference {
 public:
  Reference(const Scene& scene, int width, int height)
      : camera_(scene.camera), background_(rgb(scene.background)), width_(width), height_(height) {
    for (const Object& object : scene.objects) {
      const Finish finish = finish_of(object, scene);
      const auto& sphere = std::get<Sphere>(object.shape);
      add_ball(
          {sphere.center, sphere.radius, rgb(finish.color) * finish.diffuse, rgb(finish.emission)});
    }
    for (const Light& light : scene.lights) add_light(light);
    if (scene.key_light) add_light(*scene.key_light);
  }

  /// What a ray met, and for each light whether the point turns away from it, sees it or is in its
  /// shadow. Where this changes, the picture has an edge.
  struct Story {
    static constexpr int nothing = -1;
    enum Sight { turned_away, lit, shadowed };
    int ball = nothing;
    std::vector<Sight> lights;
    bool operator==(const Story&) const = default;
  };
  struct Answer {
    Vec3d color;
    Story story;
  };

  /// The light through a point of the raster; pixel (x, y) has its centre at (x, y) here.
  /// `lift` is the shadow rays' start above the surface, as a share of its distance (algorithms,
  /// part 1, step 4: 1e-4 at the thesis' 20 units).
  Answer trace(double x, double y, double lift = 5e-6) const {
    const Vec3d eye = camera_.location, d = direction(x, y);
    const auto [ball, t] = nearest(eye, d);
    if (ball < 0) return {background_, {}};
    const Ball& hit = balls_[static_cast<std::size_t>(ball)];
    const Vec3d p = eye + d * t;
    Vec3d n = (p - hit.center) * (1 / length(p - hit.center));
    if (dot(n, d) > 0) n = -n;
    const double extent = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), t});
    const Vec3d start = p + n * (lift * extent);
    Answer answer{hit.emission, {ball, {}}};
    for (const Source& light : sources_) {
      const Vec3d to_light = light.position - p;
      const double distance = length(to_light);
      const Vec3d l = to_light * (1 / distance);
      const double cosine = dot(n, l);
      Story::Sight sight = cosine > 0 ? Story::lit : Story::turned_away;
      if (sight == Story::lit && blocked(start, l, distance, light.own)) sight = Story::shadowed;
      if (sight == Story::lit) answer.color = answer.color + hit.albedo * light.color * cosine;
      answer.story.lights.push_back(sight);
    }
    return answer;
  }

  /// Whether the picture has an edge within 1e-3 pixels of the pixel's centre, or a shadow edge
  /// whose place hangs on how far above the surface the shadow ray starts.
  bool on_edge(int x, int y) const {
    constexpr double jitter = 1e-3;
    const Story story = trace(x, y).story;
    for (const double dx : {-jitter, jitter})
      for (const double dy : {-jitter, jitter})
        if (!(trace(x + dx, y + dy).story == story)) return true;
    return !(trace(x, y, 0.5e-6).story == story && trace(x, y, 2e-5).story == story);
  }

 private:
  struct Ball {
    Vec3d center;
    double radius;
    Vec3d albedo, emission;
  };
  struct Source {
    Vec3d position, color;
    int own;  // its own ball
  };
  struct Nearest {
    int ball;
    double t;
  };

  static Vec3d rgb(const Color& c) { return {c.r, c.g, c.b}; }

  static Finish finish_of(const Object& object, const Scene& scene) {
    if (!object.material) return {};
    if (const auto* name = std::get_if<std::string>(&*object.material))
      return std::get<Finish>(scene.materials.at(*name).kind);
    return std::get<Finish>(std::get<Boxed<Material>>(*object.material)->kind);
  }

  void add_ball(const Ball& ball) {
    balls_.push_back(ball);
    const Vec3d& e = ball.emission;
    if (e.x > 0 || e.y > 0 || e.z > 0)
      sources_.push_back({ball.center, e, static_cast<int>(balls_.size()) - 1});
  }
  void add_light(const Light& light) {
    const Vec3d color = rgb(light.color) * light.intensity;
    if (!light.place()) return;
    if (const auto* ball = std::get_if<SphereLight>(&light.kind))
      add_ball({*ball->position, ball->radius, {0, 0, 0}, color});
    else if (color.x > 0 || color.y > 0 || color.z > 0)
      sources_.push_back({*light.place(), color, -1});
  }

  Vec3d direction(double x, double y) const {
    const double sx = 2 * (x + 0.5) / width_ - 1, sy = 1 - 2 * (y + 0.5) / height_;
    Vec3d view = camera_.direction.value_or(Vec3d{0, 0, -1});
    if (camera_.look_at) view = *camera_.look_at - camera_.location;
    if (camera_.right) return unit(view + *camera_.right * sx + camera_.up * sy);
    const Vec3d w = unit(view), u = unit(cross(w, camera_.up)), v = cross(u, w);
    const double half = std::tan(camera_.fov_degrees / 2 * std::acos(-1.0) / 180);
    return unit(w + u * (sx * half * width_ / height_) + v * (sy * half));
  }
  static Vec3d unit(const Vec3d& v) { return v * (1 / std::sqrt(dot(v, v))); }

  // The smallest t > 0 with |o + t d - c| = r, or infinity.
  static double root(const Ball& ball, const Vec3d& o, const Vec3d& d) {
    const auto m = static_cast<Vec3<Long>>(o) - static_cast<Vec3<Long>>(ball.center);
    const auto way = static_cast<Vec3<Long>>(d);
    const Long a = dot(way, way), b = dot(m, way);
    const Long c = dot(m, m) - static_cast<Long>(ball.radius) * ball.radius;
    const Long discriminant = b * b - a * c;
    if (discriminant < 0) return std::numeric_limits<double>::infinity();
    const Long near = (-b - std::sqrt(discriminant)) / a, far = (-b + std::sqrt(discriminant)) / a;
    if (near > 0) return static_cast<double>(near);
    return far > 0 ? static_cast<double>(far) : std::numeric_limits<double>::infinity();
  }
  Nearest nearest(const Vec3d& o, const Vec3d& d) const {
    Nearest best{-1, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < balls_.size(); ++i)
      if (const double t = root(balls_[i], o, d); t < best.t) best = {static_cast<int>(i), t};
    return best;
  }
  bool blocked(const Vec3d& o, const Vec3d& d, double distance, int own) const {
    for (std::size_t i = 0; i < balls_.size(); ++i)
      if (static_cast<int>(i) != own && root(balls_[i], o, d) < distance) return true;
    return false;
  }

  Camera camera_;
  Vec3d background_;
  int width_, height_;
  std::vector<Ball> balls_;
  std::vector<Source> sources_;
};

}  // namespace tia::test
