// What a body is and how it moves, before and after a step.
#include "world.h"

struct BodyInput
{
    Pose pose;
    Vec velocity, angularVelocity;
    float mass;
    Vec inertia;
    Vec linearFactor, angularFactor;        // 0 along what is frozen
    float sleepThreshold;                   // J/kg
    float sweptRadius;                      // above 0 for continuous detection
    int isKinematic;
    int activity;                           // 0 as it was, 1 awake, 2 asleep
};

struct BodyOutput
{
    Pose pose;
    Vec velocity, angularVelocity;
    int isChanged, isAsleep;
};

EXPORT void rillBodySet(World* world, Actor* actor, const BodyInput* input)
{
    auto body = static_cast<btRigidBody*>(actor->object);
    bool wasKinematic = body->isKinematicObject();
    if (wasKinematic != (input->isKinematic != 0))
    {
        // How Bullet treats a body is settled as it comes in.
        bool isIn = body->getBroadphaseHandle();
        if (isIn)
            world->world.removeRigidBody(body);
        body->setMassProps(input->isKinematic ? 0 : input->mass, input->isKinematic ? btVector3(0, 0, 0) : bt(input->inertia));
        int flags = body->getCollisionFlags() & ~(btCollisionObject::CF_KINEMATIC_OBJECT | btCollisionObject::CF_STATIC_OBJECT);
        body->setCollisionFlags(input->isKinematic ? flags | btCollisionObject::CF_KINEMATIC_OBJECT : flags);
        if (isIn)
            world->world.addRigidBody(body, 2, 7);
        body->forceActivationState(ACTIVE_TAG);
    }
    if (!input->isKinematic)
        body->setMassProps(input->mass, bt(input->inertia));
    btTransform pose = bt(input->pose);
    body->setWorldTransform(pose);
    body->setInterpolationWorldTransform(pose);
    body->setLinearVelocity(bt(input->velocity));
    body->setAngularVelocity(bt(input->angularVelocity));
    body->setInterpolationLinearVelocity(bt(input->velocity));
    body->setInterpolationAngularVelocity(bt(input->angularVelocity));
    body->setLinearFactor(bt(input->linearFactor));
    body->setAngularFactor(bt(input->angularFactor));
    body->updateInertiaTensor();
    if (body->getBroadphaseHandle())
        world->world.updateSingleAabb(body);
    float slow = btSqrt(2 * btMax(input->sleepThreshold, 0.f));
    body->setSleepingThresholds(slow, slow);
    body->setCcdSweptSphereRadius(input->sweptRadius);
    body->setCcdMotionThreshold(input->sweptRadius);
    switch (input->activity)
    {
        case 1:
            body->activate(true);
            break;
        case 2:
            body->forceActivationState(ISLAND_SLEEPING);
            break;
    }
}

EXPORT void rillBodyGet(Actor* actor, const BodyInput* before, BodyOutput* after)
{
    auto body = static_cast<btRigidBody*>(actor->object);
    btTransform pose = body->getWorldTransform();
    btQuaternion turn = pose.getRotation();
    after->pose = Pose{out(pose.getOrigin()), turn.x(), turn.y(), turn.z(), turn.w()};
    after->velocity = out(body->getLinearVelocity());
    after->angularVelocity = out(body->getAngularVelocity());
    after->isChanged = !(pose == bt(before->pose)) || body->getLinearVelocity() != bt(before->velocity)
        || body->getAngularVelocity() != bt(before->angularVelocity);
    after->isAsleep = body->getActivationState() == ISLAND_SLEEPING;
}
