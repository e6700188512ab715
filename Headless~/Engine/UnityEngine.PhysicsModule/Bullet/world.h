// A thin C layer over Bullet for UnityEngine.PhysicsModule: shapes, actors with their colliders, one step, contacts, queries, joints.
// Velocities and poses are integrated by the caller; Bullet finds contacts and solves them. Units are SI.
#pragma once
#include <btBulletDynamicsCommon.h>
#include <algorithm>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#define EXPORT extern "C" __attribute__((visibility("default")))

struct Vec { float x, y, z; };
struct Pose { Vec position; float x, y, z, w; };

inline btVector3 bt(const Vec& v) { return btVector3(v.x, v.y, v.z); }
inline btTransform bt(const Pose& p) { return btTransform(btQuaternion(p.x, p.y, p.z, p.w), bt(p.position)); }
inline Vec out(const btVector3& v) { return Vec{v.x(), v.y(), v.z()}; }

// A shape and what it was made of.
struct Shape
{
    btCollisionShape* shape = nullptr;
    btStridingMeshInterface* mesh = nullptr;
    btTriangleInfoMap* edges = nullptr;
    std::vector<float> vertices;
    std::vector<int> indices;
    ~Shape();
};

enum ActorKind { Static = 0, Body = 1, Trigger = 2 };

// One collision object: a body with all its colliders, a collider without body, or a trigger.
struct Actor
{
    ActorKind kind = Static;
    btCollisionObject* object = nullptr;
    btCompoundShape* compound = nullptr;
    std::vector<int> colliders;
};

// What a collider does at a contact.
struct Collider
{
    int body;                   // of its Rigidbody, below 0 for none
    int flags;                  // 1 trigger, 2 its body is moved by forces, 4 its body detects no collisions
    int layer;
    uint32_t includes, excludes;
    float staticFriction, dynamicFriction, bounciness;
    int frictionCombine, bounceCombine;     // 0 average, 1 multiply, 2 minimum, 3 maximum
};

struct Contact
{
    int colliderA, colliderB;
    Vec point, normal;          // the normal points from B to A
    float separation, impulse;
};

struct World;

// Opens the parts of a step, without Bullet's own integration.
struct SteppedWorld : btDiscreteDynamicsWorld
{
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
    void stepOnce(World& world, float time);
};

struct World
{
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    SteppedWorld world;
    std::unordered_map<int, Collider> colliders;
    std::set<std::pair<int, int>> ignored;
    uint32_t layers[32];        // which layers each meets
    std::vector<Contact> contacts;
    std::set<Actor*> actors;
    std::set<struct JointActor*> joints;

    World();
    ~World();
    const Collider* find(int id) const;
    bool mayMeet(int a, int b) const;
    bool mayMeet(const Actor& a, const Actor& b) const;
    void wakeTouched(const btCollisionObject* object);
};

struct JointActor;
EXPORT void rillActorDelete(World* world, Actor* actor);
EXPORT void rillJointDelete(World* world, JointActor* joint);

// Of a contact's side: the collider whose shape was hit.
int colliderOf(const btCollisionObjectWrapper* side);
inline Actor* actorOf(const btCollisionObject* object) { return static_cast<Actor*>(object->getUserPointer()); }
