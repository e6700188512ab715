// What a shape or a ray finds: colliders by their ids. Which of them count is the caller's.
#include "world.h"
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <algorithm>

struct Hit
{
    int collider;
    float distance;     // m
    Vec point, normal;
};

struct Overlaps : btCollisionWorld::ContactResultCallback
{
    const btCollisionObject* asked;
    std::set<int> found;

    explicit Overlaps(const btCollisionObject* asked) : asked(asked) { m_collisionFilterGroup = m_collisionFilterMask = -1; }

    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int, const btCollisionObjectWrapper* b, int, int) override
    {
        if (point.getDistance() <= 0)
            found.insert(colliderOf(a->getCollisionObject() == asked ? b : a));
        return 0;
    }
};

// Returns how many there are, of which the first are written in the order of their ids.
EXPORT int rillOverlap(World* world, Shape* shape, Pose pose, int* ids, int capacity)
{
    btCollisionObject asked;
    Actor actor;
    asked.setUserPointer(&actor);
    asked.setCollisionShape(shape->shape);
    asked.setWorldTransform(bt(pose));
    shape->shape->setUserIndex(-1);
    actor.colliders.push_back(-1);
    Overlaps overlaps(&asked);
    world->world.contactTest(&asked, overlaps);
    int count = 0;
    for (int id : overlaps.found)
        if (count++ < capacity)
            ids[count - 1] = id;
    return count;
}

// Bullet tells of a child of a compound by its index.
static int hitCollider(const btCollisionObject* object, const btCollisionWorld::LocalShapeInfo* info)
{
    const Actor* actor = actorOf(object);
    bool isOfCompound = actor->compound && info && info->m_triangleIndex >= 0 && info->m_triangleIndex < (int)actor->colliders.size();
    return actor->colliders[isOfCompound ? info->m_triangleIndex : 0];
}

static int write(std::vector<Hit>& hits, Hit* out, int capacity)
{
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.collider < b.collider;
    });
    // A collider is hit once, at its nearest point.
    std::set<int> told;
    int count = 0;
    for (const Hit& hit : hits)
        if (told.insert(hit.collider).second && count++ < capacity)
            out[count - 1] = hit;
    return count;
}

struct Rays : btCollisionWorld::RayResultCallback
{
    btVector3 from, to;
    float length;
    std::vector<Hit> hits;

    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool isInWorld) override
    {
        btVector3 normal = isInWorld ? result.m_hitNormalLocal
            : result.m_collisionObject->getWorldTransform().getBasis() * result.m_hitNormalLocal;
        m_collisionObject = result.m_collisionObject;
        hits.push_back(Hit{hitCollider(result.m_collisionObject, result.m_localShapeInfo), result.m_hitFraction * length,
            out(from.lerp(to, result.m_hitFraction)), out(normal.normalized())});
        return 1;
    }
};

// The distance up to which there can be anything: long ways lose digits.
static float reach(World* world, const btVector3& from, float distance)
{
    btVector3 low, high;
    world->broadphase.getBroadphaseAabb(low, high);
    btVector3 farthest = (from - low).absolute();
    farthest.setMax((from - high).absolute());
    return btMin(distance, farthest.length() + 1);
}

EXPORT int rillRay(World* world, Vec origin, Vec direction, float distance, int hitsBackfaces, Hit* hits, int capacity)
{
    Rays rays;
    rays.from = bt(origin);
    rays.length = reach(world, rays.from, distance);
    rays.to = rays.from + bt(direction) * rays.length;
    rays.m_collisionFilterGroup = rays.m_collisionFilterMask = -1;
    if (!hitsBackfaces)
        rays.m_flags |= btTriangleRaycastCallback::kF_FilterBackfaces;
    world->world.rayTest(rays.from, rays.to, rays);
    return write(rays.hits, hits, capacity);
}

struct Sweeps : btCollisionWorld::ConvexResultCallback
{
    float length;
    std::vector<Hit> hits;

    btScalar addSingleResult(btCollisionWorld::LocalConvexResult& result, bool isInWorld) override
    {
        btVector3 normal = isInWorld ? result.m_hitNormalLocal
            : result.m_hitCollisionObject->getWorldTransform().getBasis() * result.m_hitNormalLocal;
        hits.push_back(Hit{hitCollider(result.m_hitCollisionObject, result.m_localShapeInfo), result.m_hitFraction * length,
            out(result.m_hitPointLocal), out(normal)});
        return 1;
    }
};

EXPORT int rillSweep(World* world, Shape* shape, Pose from, Vec direction, float distance, Hit* hits, int capacity)
{
    if (!shape->shape->isConvex())
        return 0;
    Sweeps sweeps;
    sweeps.m_collisionFilterGroup = sweeps.m_collisionFilterMask = -1;
    btTransform start = bt(from), end = start;
    sweeps.length = reach(world, start.getOrigin(), distance);
    end.setOrigin(start.getOrigin() + bt(direction) * sweeps.length);
    world->world.convexSweepTest(static_cast<btConvexShape*>(shape->shape), start, end, sweeps);
    return write(sweeps.hits, hits, capacity);
}

// The depth of A in B, positive where they overlap; the direction leads A out. Convex shapes alone.
EXPORT int rillPenetration(Shape* a, Pose poseA, Shape* b, Pose poseB, Vec* direction, float* depth)
{
    if (!a->shape->isConvex() || !b->shape->isConvex())
        return 0;
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver epa;
    btGjkPairDetector detector(static_cast<btConvexShape*>(a->shape), static_cast<btConvexShape*>(b->shape), &simplex, &epa);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = bt(poseA);
    input.m_transformB = bt(poseB);
    btPointCollector result;
    detector.getClosestPoints(input, result, nullptr);
    *direction = out(result.m_normalOnBInWorld);
    *depth = -result.m_distance;
    return result.m_hasResult ? 1 : 0;
}

// The point of a convex shape that is nearest to a point; that point itself where it is inside.
EXPORT Vec rillClosest(Shape* shape, Pose pose, Vec point)
{
    Shape dot;
    dot.shape = new btSphereShape(0);
    Vec direction;
    float depth;
    Pose at{point, 0, 0, 0, 1};
    if (!rillPenetration(&dot, at, shape, pose, &direction, &depth) || depth >= 0)
        return point;
    return out(bt(point) + bt(direction) * depth);
}
