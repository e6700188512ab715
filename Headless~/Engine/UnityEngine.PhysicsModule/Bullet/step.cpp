// One step: contacts are found, filtered by their colliders, solved and handed out.
#include "world.h"
#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

static World* active;       // of the step that runs: Bullet's callbacks have no argument for it

static const int Lost = -2;                 // a contact that does not count
static const float Touching = 0.01f;        // m: Unity's contact offset, up to which a contact goes on
static const float Sliding = 0.01f;         // m/s: from there on the dynamic friction holds

int colliderOf(const btCollisionObjectWrapper* side)
{
    // A triangle's own shape lives for the test alone: the mesh is above it.
    for (auto at = side; at; at = at->m_parent)
        if (at->getCollisionShape()->getUserIndex() >= 0)
            return at->getCollisionShape()->getUserIndex();
    return actorOf(side->getCollisionObject())->colliders[0];
}

// Triangles are met on their front alone, as in Unity.
static bool isBehind(const btCollisionObjectWrapper* side, const btVector3& towardsOther)
{
    if (side->getCollisionShape()->getShapeType() != TRIANGLE_SHAPE_PROXYTYPE)
        return false;
    btVector3 normal;
    static_cast<const btTriangleShape*>(side->getCollisionShape())->calcNormal(normal);
    return (side->getWorldTransform().getBasis() * normal).dot(towardsOther) < 0;
}

static bool onContact(btManifoldPoint& point, const btCollisionObjectWrapper* a, int partA, int indexA, const btCollisionObjectWrapper* b,
    int partB, int indexB)
{
    bool isLost = isBehind(b, point.m_normalWorldOnB) || isBehind(a, -point.m_normalWorldOnB);
    // A body that slides over the edge between two triangles must not stumble there.
    btAdjustInternalEdgeContacts(point, b, a, partB, indexB);
    point.m_index0 = isLost ? Lost : colliderOf(a);
    point.m_index1 = colliderOf(b);
    return true;
}

static void onNear(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info)
{
    auto a = static_cast<btCollisionObject*>(pair.m_pProxy0->m_clientObject), b = static_cast<btCollisionObject*>(pair.m_pProxy1->m_clientObject);
    if (active->mayMeet(*actorOf(a), *actorOf(b)))
        btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
    else
        active->broadphase.getOverlappingPairCache()->cleanOverlappingPair(pair, &dispatcher);
}

static float combine(float a, float b, int modeA, int modeB)
{
    static const int rank[] = {0, 2, 1, 3};     // average, minimum, multiply, maximum
    switch (rank[modeA & 3] > rank[modeB & 3] ? modeA : modeB)
    {
        case 1: return a * b;
        case 2: return btMin(a, b);
        case 3: return btMax(a, b);
        default: return 0.5f * (a + b);
    }
}

static btVector3 velocityAt(const btCollisionObject* object, const btVector3& point)
{
    const btRigidBody* body = btRigidBody::upcast(object);
    return body ? body->getVelocityInLocalPoint(point - body->getCenterOfMassPosition()) : btVector3(0, 0, 0);
}

static void setMaterial(const World& world, const btPersistentManifold& manifold, btManifoldPoint& point)
{
    const Collider &a = *world.find(point.m_index0), &b = *world.find(point.m_index1);
    btVector3 between = velocityAt(manifold.getBody0(), point.getPositionWorldOnA()) - velocityAt(manifold.getBody1(), point.getPositionWorldOnB());
    between -= point.m_normalWorldOnB * between.dot(point.m_normalWorldOnB);
    point.m_combinedFriction = between.length() < Sliding ? combine(a.staticFriction, b.staticFriction, a.frictionCombine, b.frictionCombine)
        : combine(a.dynamicFriction, b.dynamicFriction, a.frictionCombine, b.frictionCombine);
    point.m_combinedRestitution = combine(a.bounciness, b.bounciness, a.bounceCombine, b.bounceCombine);
}

// A body of several colliders meets as one object: here each of its contacts is looked at.
static void filter(World& world)
{
    for (int i = 0; i < world.dispatcher.getNumManifolds(); i++)
    {
        btPersistentManifold* manifold = world.dispatcher.getManifoldByIndexInternal(i);
        for (int p = manifold->getNumContacts() - 1; p >= 0; p--)
        {
            btManifoldPoint& point = manifold->getContactPoint(p);
            if (point.m_index0 == -1)       // foreseen for a fast body: Bullet tells of no shapes
            {
                point.m_index0 = actorOf(manifold->getBody0())->colliders[0];
                point.m_index1 = actorOf(manifold->getBody1())->colliders[0];
            }
            if (point.m_index0 == Lost || !world.mayMeet(point.m_index0, point.m_index1))
                manifold->removeContactPoint(p);
            else
                setMaterial(world, *manifold, point);
        }
    }
}

static void collect(World& world)
{
    world.contacts.clear();
    for (int i = 0; i < world.dispatcher.getNumManifolds(); i++)
    {
        const btPersistentManifold* manifold = world.dispatcher.getManifoldByIndexInternal(i);
        for (int p = 0; p < manifold->getNumContacts(); p++)
        {
            const btManifoldPoint& point = manifold->getContactPoint(p);
            if (point.getDistance() <= Touching)
                world.contacts.push_back(Contact{point.m_index0, point.m_index1, out(point.getPositionWorldOnB()), out(point.m_normalWorldOnB),
                    point.getDistance(), point.getAppliedImpulse()});
        }
    }
    std::stable_sort(world.contacts.begin(), world.contacts.end(), [](const Contact& a, const Contact& b) {
        return std::minmax(a.colliderA, a.colliderB) < std::minmax(b.colliderA, b.colliderB);
    });
}

void SteppedWorld::stepOnce(World& owner, float time)
{
    active = &owner;
    gContactAddedCallback = onContact;
    owner.dispatcher.setNearCallback(onNear);
    getDispatchInfo().m_timeStep = time;
    getDispatchInfo().m_stepCount = 0;
    getSolverInfo().m_timeStep = time;
    predictUnconstraintMotion(time);
    createPredictiveContacts(time);
    performDiscreteCollisionDetection();
    filter(owner);
    calculateSimulationIslands();
    solveConstraints(getSolverInfo());
    updateActivationState(time);
    collect(owner);
    active = nullptr;
}

// Returns the number of contacts.
EXPORT int rillWorldStep(World* world, float time, float bounceThreshold)
{
    world->world.getSolverInfo().m_restitutionVelocityThreshold = bounceThreshold;
    world->world.stepOnce(*world, time);
    return static_cast<int>(world->contacts.size());
}

EXPORT void rillWorldContacts(const World* world, Contact* contacts)
{
    std::copy(world->contacts.begin(), world->contacts.end(), contacts);
}
