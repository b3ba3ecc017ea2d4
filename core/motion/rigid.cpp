#include "core/motion/rigid.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <utility>

#include "core/motion/exact.h"
#include "core/motion/thinned.h"
#include "core/parallel/stopped.h"

namespace tia {
namespace {

// Bullet's tolerances are for things of about one metre: lengths are told in a body's radius.
// What it allocates throws where there is no memory, as everything here does.
constexpr std::align_val_t most_aligned{64};  // it asks for 16
void* allocate_for_bullet(std::size_t bytes, int) { return ::operator new(bytes, most_aligned); }
void free_of_bullet(void* memory) { ::operator delete(memory, most_aligned); }

const RigidWorld& world_of(const btCollisionObject* object) {
  return *static_cast<const RigidWorld*>(object->getUserPointer());
}
std::size_t number_of(const btCollisionObject* object) {
  return static_cast<std::size_t>(object->getUserIndex());
}
btScalar pair_restitution(const btCollisionObject* a, const btCollisionObject* b) {
  return world_of(a).restitution(number_of(a), number_of(b));
}
btScalar pair_friction(const btCollisionObject* a, const btCollisionObject* b) {
  return world_of(a).friction(number_of(a), number_of(b));
}

// Once in the program: they are the same for all.
void set_up_bullet() {
  static const bool done = [] {
    btAlignedAllocSetCustomAligned(allocate_for_bullet, free_of_bullet);
    gCalculateCombinedRestitutionCallback = pair_restitution;
    gCalculateCombinedFrictionCallback = pair_friction;
    return true;
  }();
  static_cast<void>(done);
}

/// BulletScale: lengths there and back.
struct BulletScale {
  double unit = 1;
  btVector3 there(const Vec3d& v) const { return {v.x / unit, v.y / unit, v.z / unit}; }
  Vec3d back(const btVector3& v) const { return {v.x() * unit, v.y() * unit, v.z() * unit}; }
  btTransform there(const Affine& frame) const {
    const btMatrix3x3 axes(frame.x.x, frame.y.x, frame.z.x, frame.x.y, frame.y.y, frame.z.y,
                           frame.x.z, frame.y.z, frame.z.z);
    return btTransform(axes, there(frame.offset));
  }
};

using BulletShape = std::unique_ptr<btCollisionShape>;

/// BulletShapes: Bullet's shapes of ours, and what they refer to.
class BulletShapes {
 public:
  explicit BulletShapes(const BulletScale& scale) : scale_(scale) {}

  btCollisionShape* add(const RigidShape& shape) {
    return keep(std::visit([&](const auto& each) { return this->made(each); }, shape));
  }
  btCollisionShape* at(btCollisionShape* child, const btTransform& frame) {
    auto compound = std::make_unique<btCompoundShape>(false, 1);
    compound->addChildShape(frame, child);
    return keep(std::move(compound));
  }

 private:
  static constexpr double thin = 1e-3;  // what Bullet adds around hulls, in units

  btCollisionShape* keep(BulletShape shape) {
    shapes_.push_back(std::move(shape));
    return shapes_.back().get();
  }
  double length(double of) const { return of / scale_.unit; }

  BulletShape made(const RigidSphere& s) {
    return std::make_unique<btSphereShape>(length(s.radius));
  }
  BulletShape made(const RigidBox& box) {
    auto made = std::make_unique<btBoxShape>(scale_.there(box.half));
    made->setMargin(thin);
    return made;
  }
  BulletShape made(const RigidCylinder& c) {
    auto made = std::make_unique<btCylinderShape>(
        btVector3(length(c.radius), length(c.half_height), length(c.radius)));
    made->setMargin(thin);
    return made;
  }
  BulletShape made(const RigidCone& c) {
    auto made = std::make_unique<btConeShape>(length(c.radius), 2 * length(c.half_height));
    made->setMargin(thin);
    return made;
  }
  BulletShape made(const RigidCapsule& c) {
    return std::make_unique<btCapsuleShape>(length(c.radius), 2 * length(c.half_height));
  }
  BulletShape made(const RigidHull& hull) {
    auto made = std::make_unique<btConvexHullShape>();
    for (const Vec3d& p : hull.points) made->addPoint(scale_.there(p), false);
    made->optimizeConvexHull();
    made->recalcLocalAabb();
    made->setMargin(thin);
    return made;
  }
  BulletShape made(const RigidPlane& plane) {
    const Vec3d n = plane.normal;
    return std::make_unique<btStaticPlaneShape>(btVector3(n.x, n.y, n.z), 0);
  }
  BulletShape made(const RigidMesh& mesh) {
    auto& triangles = meshes_.emplace_back(std::make_unique<btTriangleMesh>());
    for (const auto& [a, b, c] : mesh.triangles)
      triangles->addTriangle(scale_.there(mesh.points[a]), scale_.there(mesh.points[b]),
                             scale_.there(mesh.points[c]));
    auto made = std::make_unique<btBvhTriangleMeshShape>(triangles.get(), true);
    made->setMargin(thin);
    return made;
  }

  BulletScale scale_;
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
  std::vector<BulletShape> shapes_;
};

double median_radius(const RigidWorld& world) {
  std::vector<double> radii;
  for (const RigidBody& body : world.bodies) radii.push_back(body.radius);
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

/// BulletRun: one world, from 0 to its end.
class BulletRun {
 public:
  explicit BulletRun(const RigidWorld& world)
      : world_(world), scale_{median_radius(world)}, shapes_(scale_) {
    // As many contacts each step as hold a face: kept ones are lost where it slides.
    configuration_.setPlaneConvexMultipointIterations(8, 4);
    bullet_.setGravity(scale_.there(world.gravity));
    btContactSolverInfo& info = bullet_.getSolverInfo();
    info.m_numIterations = 50;
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;  // with one, what stands drifts
    // What gravity alone does in two steps is no bounce.
    info.m_restitutionVelocityThreshold = 2 * length(scale_.there(world.gravity)) * step;
    info.m_splitImpulsePenetrationThreshold = 0;  // to be pushed out gives no speed
    for (std::size_t i = 0; i < world.bodies.size(); ++i) add_body(i);
    for (std::size_t i = 0; i < world.fixed.size(); ++i) add_fixed(i);
    motion_.poses.resize(world.bodies.size());
    is_touched_.resize(bodies_.size());
  }
  RigidMotion operator()(const std::stop_token& stop) {
    const auto steps = static_cast<std::size_t>(std::ceil(world_.duration * rigid_steps - 1e-9));
    for (std::size_t k = 0; k <= steps; ++k) {
      end_if_asked(stop);
      time_ = static_cast<double>(k) / rigid_steps;
      come_and_go();
      tell();
      if (k < steps) bullet_.stepSimulation(step, 0);
      note_contacts(time_ + step);
    }
    motion_.energy = std::move(energies_).take();
    return std::move(motion_);
  }

 private:
  static constexpr double step = 1.0 / rigid_steps;
  static double length(const btVector3& v) { return v.length(); }
  // Velocities are those of the middles of steps, so that positions are exact to the second order
  // (leapfrog: Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, I.1.4).
  Vec3d half_pull() const { return world_.gravity * (step / 2); }

  std::unique_ptr<btRigidBody> made(double mass, btCollisionShape* shape, const btVector3& moments,
                                    const btTransform& at, std::size_t number) {
    auto body = std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, shape, moments));
    body->setWorldTransform(at);
    body->setInterpolationWorldTransform(at);
    body->setUserPointer(const_cast<RigidWorld*>(&world_));
    body->setUserIndex(static_cast<int>(number));
    body->setActivationState(DISABLE_DEACTIVATION);
    // What rests is met before it touches, all else when it does: else it would be stopped short of
    // that, and bounce with what is left.
    body->setContactProcessingThreshold(2 * length(scale_.there(world_.gravity)) * step * step);
    return body;
  }

  void add_body(std::size_t i) {
    const RigidBody& body = world_.bodies[i];
    const btTransform frame = scale_.there(body.frame), part = scale_.there(body.part.frame);
    btCollisionShape* shape = shapes_.add(body.part.shape);
    if (!(body.part.frame == body.frame)) shape = shapes_.at(shape, frame.inverse() * part);
    const double square = scale_.unit * scale_.unit;
    const btVector3 moments(body.moments.x / square, body.moments.y / square,
                            body.moments.z / square);
    auto made_body = made(body.mass, shape, moments, frame, i);
    made_body->setLinearVelocity(scale_.there(body.velocity - half_pull()));
    made_body->setAngularVelocity({body.spin.x, body.spin.y, body.spin.z});
    made_body->setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
    // Faster than half of its radius a step it is swept.
    const double radius = body.radius / scale_.unit;
    made_body->setCcdMotionThreshold(radius / 2);
    made_body->setCcdSweptSphereRadius(radius / 5);
    start_.push_back(frame.getRotation());
    bodies_.push_back(std::move(made_body));
    is_in_.push_back(false);
  }
  void add_fixed(std::size_t i) {
    const RigidPart& part = world_.fixed[i];
    bodies_.push_back(made(0, shapes_.add(part.shape), {0, 0, 0}, scale_.there(part.frame),
                           world_.bodies.size() + i));
    is_in_.push_back(true);
    bullet_.addRigidBody(bodies_.back().get());
  }

  void come_and_go() {
    bool some = false;
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      const RigidBody& body = world_.bodies[i];
      const bool is_there = body.enters <= time_ + 1e-9 && time_ < body.leaves;
      entered_[i] = is_there && !is_in_[i];
      if (is_there == is_in_[i]) continue;
      some = true;
      is_in_[i] = is_there;
      if (is_there) bullet_.addRigidBody(bodies_[i].get());
      else bullet_.removeRigidBody(bodies_[i].get());
    }
    if (some) refuse_overlaps();
  }

  // Deeper than a hundredth of the smaller one's radius: less is how what touches was written.
  void refuse_overlaps() {
    bullet_.performDiscreteCollisionDetection();
    for (int k = 0; k < dispatcher_.getNumManifolds(); ++k) {
      const btPersistentManifold& two = *dispatcher_.getManifoldByIndexInternal(k);
      const auto [a, b] = std::minmax({number_of(two.getBody0()), number_of(two.getBody1())});
      if (!entered_[a] && !(b < world_.bodies.size() && entered_[b])) continue;
      const double least = std::min(radius_of(a), radius_of(b)) / scale_.unit;
      for (int p = 0; p < two.getNumContacts(); ++p)
        if (two.getContactPoint(p).getDistance() < -0.01 * least) throw BodiesOverlap(a, b, time_);
    }
  }
  double radius_of(std::size_t number) const {
    return number < world_.bodies.size() ? world_.bodies[number].radius
                                         : std::numeric_limits<double>::infinity();
  }

  void tell() {
    BodyEnergy energy{time_};
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      if (!is_in_[i]) continue;
      const btRigidBody& body = *bodies_[i];
      const btQuaternion turned = body.getWorldTransform().getRotation() * start_[i].inverse();
      const Vec3d center = scale_.back(body.getWorldTransform().getOrigin());
      Vec3d velocity = scale_.back(body.getLinearVelocity());
      if (!is_touched_[i]) velocity = velocity + half_pull();
      const btVector3 spin =
          body.getWorldTransform().getBasis().transpose() * body.getAngularVelocity();
      const Vec3d moments = world_.bodies[i].moments;
      const double mass = world_.bodies[i].mass;
      motion_.poses[i].push_back({time_, center, {turned.x(), turned.y(), turned.z(), turned.w()}});
      energy.kinetic += (mass * dot(velocity, velocity) + moments.x * spin.x() * spin.x() +
                         moments.y * spin.y() * spin.y() + moments.z * spin.z() * spin.z()) /
                        2;
      energy.potential -= mass * dot(world_.gravity, center);
      ++motion_.steps;
    }
    energies_.add(energy);
  }

  // Those that begin: of pairs that did not touch in the step before.
  void note_contacts(double time) {
    std::map<std::pair<std::size_t, std::size_t>, BodyContact> now;
    for (int k = 0; k < dispatcher_.getNumManifolds(); ++k) {
      const btPersistentManifold& two = *dispatcher_.getManifoldByIndexInternal(k);
      for (int p = 0; p < two.getNumContacts(); ++p) add_contact(two, p, time, now);
    }
    is_touched_.assign(bodies_.size(), false);
    for (const auto& [pair, contact] : now) {
      is_touched_[pair.first] = is_touched_[pair.second] = true;
      if (!touching_.contains(pair) && motion_.contacts.size() < Motion::most_records)
        motion_.contacts.push_back(contact);
    }
    touching_ = std::move(now);
  }
  void add_contact(const btPersistentManifold& two, int p, double time,
                   std::map<std::pair<std::size_t, std::size_t>, BodyContact>& now) const {
    const btManifoldPoint& point = two.getContactPoint(p);
    if (!(point.getAppliedImpulse() > 0)) return;
    std::size_t a = number_of(two.getBody0()), b = number_of(two.getBody1());
    const btVector3& n = point.m_normalWorldOnB;
    Vec3d normal{n.x(), n.y(), n.z()};
    if (a > b) std::swap(a, b), normal = -normal;
    BodyContact& contact = now[{a, b}];
    if (contact.impulse == 0)
      contact = {time, a, b, scale_.back(point.getPositionWorldOnB()), normal, 0};
    contact.impulse += point.getAppliedImpulse() * scale_.unit;
  }

  const RigidWorld& world_;
  BulletScale scale_;
  BulletShapes shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  // which outlive the world that they are in
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld bullet_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<btQuaternion> start_;
  std::vector<char> is_in_, is_touched_;
  std::map<std::size_t, bool> entered_;
  std::map<std::pair<std::size_t, std::size_t>, BodyContact> touching_;
  double time_ = 0;
  RigidMotion motion_;
  Thinned<BodyEnergy> energies_{Motion::most_records};
};

}  // namespace

RigidMotion solve_rigid(const RigidWorld& world, const std::stop_token& stop) {
  set_up_bullet();
  return BulletRun(world)(stop);
}

}  // namespace tia
