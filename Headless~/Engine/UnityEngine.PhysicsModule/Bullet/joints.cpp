// Joints: six degrees of freedom between two frames, each locked, limited, free, sprung or driven.
#include "world.h"
#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>

struct Axis
{
    float low, high;                    // m or radians; low above high is free
    float bounciness;
    float spring, damper, target;       // the spring is off at 0
    int isDriven;
    float velocity, maxForce;
};

struct JointActor
{
    btGeneric6DofSpring2Constraint* constraint;
    btJointFeedback feedback;
};

// b may be null for the world. Frames are in the actors' own, or in the world's. Angles are those of a against b.
EXPORT JointActor* rillJointNew(World* world, Actor* a, Pose frameA, Actor* b, Pose frameB, int collides)
{
    auto joint = new JointActor;
    world->joints.insert(joint);
    btRigidBody &bodyA = *static_cast<btRigidBody*>(a->object),
        &bodyB = b ? *static_cast<btRigidBody*>(b->object) : btTypedConstraint::getFixedBody();
    joint->constraint = new btGeneric6DofSpring2Constraint(bodyA, bodyB, bt(frameA), bt(frameB));
    joint->constraint->setJointFeedback(&joint->feedback);
    world->world.addConstraint(joint->constraint, !collides);
    return joint;
}

EXPORT void rillJointSet(JointActor* joint, const Axis* axes)
{
    btGeneric6DofSpring2Constraint& constraint = *joint->constraint;
    for (int i = 0; i < 6; i++)
    {
        const Axis& axis = axes[i];
        constraint.setLimit(i, axis.low, axis.high);
        constraint.setBounce(i, axis.bounciness);
        constraint.setParam(BT_CONSTRAINT_STOP_ERP, 0.8f, i);
        constraint.enableMotor(i, axis.isDriven != 0);
        constraint.setTargetVelocity(i, axis.velocity);
        constraint.setMaxMotorForce(i, axis.maxForce);
        constraint.enableSpring(i, axis.spring > 0 || axis.damper > 0);
        constraint.setStiffness(i, axis.spring);
        constraint.setDamping(i, axis.damper);
        constraint.setEquilibriumPoint(i, axis.target);
    }
}

// The force and the torque of the last step on A, and the angle about x.
EXPORT void rillJointGet(JointActor* joint, Vec* force, Vec* torque, float* angle)
{
    *force = out(joint->feedback.m_appliedForceBodyA);
    *torque = out(joint->feedback.m_appliedTorqueBodyA);
    joint->constraint->calculateTransforms();
    *angle = joint->constraint->getAngle(0);
}

EXPORT void rillJointDelete(World* world, JointActor* joint)
{
    world->world.removeConstraint(joint->constraint);
    delete joint->constraint;
    world->joints.erase(joint);
    delete joint;
}
