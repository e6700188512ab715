// Worlds, actors and what their colliders are.
#include "world.h"

static const float SleepTime = 0.4f;        // s that a body of PhysX stays awake after its last movement

World::World() : dispatcher(&configuration), world(&dispatcher, &broadphase, &solver, &configuration)
{
    gDeactivationTime = SleepTime;
    world.setGravity(btVector3(0, 0, 0));
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    btContactSolverInfo& info = world.getSolverInfo();
    info.m_numIterations = 20;
    info.m_splitImpulse = true;
    info.m_splitImpulsePenetrationThreshold = 0;    // depth is taken back without a gain of velocity
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    for (uint32_t& mask : layers)
        mask = ~0u;
}

World::~World()
{
    while (!joints.empty())
        rillJointDelete(this, *joints.begin());
    while (!actors.empty())
        rillActorDelete(this, *actors.begin());
}

const Collider* World::find(int id) const
{
    auto found = colliders.find(id);
    return found == colliders.end() ? nullptr : &found->second;
}

// Unity's overrides win over the matrix of layers, and those that leave out over those that take in.
static bool meetsLayers(const World& world, const Collider& a, const Collider& b)
{
    uint32_t bitA = 1u << a.layer, bitB = 1u << b.layer;
    if ((a.excludes & bitB) || (b.excludes & bitA))
        return false;
    return (a.includes & bitB) || (b.includes & bitA) || (world.layers[a.layer] & bitB);
}

bool World::mayMeet(int idA, int idB) const
{
    const Collider *a = find(idA), *b = find(idB);
    if (!a || !b || (a->body < 0 && b->body < 0) || a->body == b->body || ((a->flags | b->flags) & 4))
        return false;
    bool isTrigger = (a->flags | b->flags) & 1, isMoved = (a->flags | b->flags) & 2;
    return (isTrigger || isMoved) && meetsLayers(*this, *a, *b) && !ignored.count(std::minmax(idA, idB));
}

bool World::mayMeet(const Actor& a, const Actor& b) const
{
    for (int idA : a.colliders)
        for (int idB : b.colliders)
            if (mayMeet(idA, idB))
                return true;
    return false;
}

void World::wakeTouched(const btCollisionObject* object)
{
    for (int i = 0; i < dispatcher.getNumManifolds(); i++)
    {
        btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
        const btCollisionObject* other = manifold->getBody0() == object ? manifold->getBody1()
            : manifold->getBody1() == object ? manifold->getBody0() : nullptr;
        if (other && manifold->getNumContacts() > 0)
            const_cast<btCollisionObject*>(other)->activate();
    }
}

EXPORT World* rillWorldNew() { return new World; }
EXPORT void rillWorldDelete(World* world) { delete world; }

EXPORT void rillWorldLayers(World* world, const uint32_t* masks)
{
    for (int i = 0; i < 32; i++)
        world->layers[i] = masks[i];
}

EXPORT void rillWorldIgnore(World* world, int a, int b, int isIgnored)
{
    if (isIgnored)
        world->ignored.insert(std::minmax(a, b));
    else
        world->ignored.erase(std::minmax(a, b));
}

EXPORT void rillColliderSet(World* world, int id, const Collider* collider) { world->colliders[id] = *collider; }
EXPORT void rillColliderRemove(World* world, int id) { world->colliders.erase(id); }

EXPORT Actor* rillActorNew(World* world, int kind)
{
    auto actor = new Actor;
    world->actors.insert(actor);
    actor->kind = static_cast<ActorKind>(kind);
    if (kind == Body)
        actor->object = new btRigidBody(1, nullptr, new btEmptyShape, btVector3(1, 1, 1));
    else
        actor->object = new btCollisionObject;
    btCollisionObject* object = actor->object;
    object->setUserPointer(actor);
    if (kind == Body)
        static_cast<btRigidBody*>(object)->setFlags(0);     // no gyroscopic forces, as in Unity
    else
        object->setCollisionFlags(kind == Trigger ? btCollisionObject::CF_KINEMATIC_OBJECT | btCollisionObject::CF_NO_CONTACT_RESPONSE
            : btCollisionObject::CF_STATIC_OBJECT);
    object->setCollisionFlags(object->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    return actor;
}

static void takeOut(World* world, Actor* actor)
{
    if (!actor->object->getBroadphaseHandle())
        return;
    world->wakeTouched(actor->object);
    if (actor->kind == Body)
        world->world.removeRigidBody(static_cast<btRigidBody*>(actor->object));
    else
        world->world.removeCollisionObject(actor->object);
}

static void putIn(World* world, Actor* actor)
{
    // Colliders without bodies never meet each other.
    if (actor->kind == Body)
        world->world.addRigidBody(static_cast<btRigidBody*>(actor->object), 2, 7);
    else
        world->world.addCollisionObject(actor->object, actor->kind == Static ? 1 : 4, actor->kind == Static ? 6 : 7);
}

EXPORT void rillActorDelete(World* world, Actor* actor)
{
    takeOut(world, actor);
    if (actor->object->getCollisionShape() && actor->object->getCollisionShape()->getShapeType() == EMPTY_SHAPE_PROXYTYPE)
        delete actor->object->getCollisionShape();
    delete actor->object;
    delete actor->compound;
    world->actors.erase(actor);
    delete actor;
}

// Gives an actor its shapes, each with its collider and its pose in the actor's frame. One without any stays out of contacts.
EXPORT void rillActorShapes(World* world, Actor* actor, int count, Shape** shapes, const int* colliders, const Pose* poses)
{
    takeOut(world, actor);
    btCollisionShape* old = actor->object->getCollisionShape();
    if (old && old->getShapeType() == EMPTY_SHAPE_PROXYTYPE)
        delete old;
    delete actor->compound;
    actor->compound = nullptr;
    actor->colliders.assign(colliders, colliders + count);
    for (int i = 0; i < count; i++)
        shapes[i]->shape->setUserIndex(colliders[i]);
    bool isAlone = count == 1 && bt(poses[0]) == btTransform::getIdentity();
    if (count > 0 && !isAlone)
    {
        actor->compound = new btCompoundShape(true, count);
        for (int i = 0; i < count; i++)
            actor->compound->addChildShape(bt(poses[i]), shapes[i]->shape);
    }
    actor->object->setCollisionShape(isAlone ? shapes[0]->shape : count > 0 ? static_cast<btCollisionShape*>(actor->compound) : new btEmptyShape);
    putIn(world, actor);
}

// Where it is now: a body's center of mass with its principal axes, another's collider.
EXPORT void rillActorPose(World* world, Actor* actor, Pose pose)
{
    btTransform now = bt(pose);
    if (actor->kind == Static && !(actor->object->getWorldTransform() == now))
        world->wakeTouched(actor->object);
    actor->object->setWorldTransform(now);
    actor->object->setInterpolationWorldTransform(now);
    if (actor->object->getBroadphaseHandle())
        world->world.updateSingleAabb(actor->object);
}
