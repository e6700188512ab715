using System;
using System.Runtime.InteropServices;

namespace UnityEngine.Headless
{
    /// <summary>The layer over Bullet in world.cpp and its neighbors. Structs are laid out as there.</summary>
    internal static class Bullet
    {
        const string Library = "librillbullet";

        [DllImport(Library, EntryPoint = "rillShapeBox")] public static extern IntPtr ShapeBox(Vector3 half);
        [DllImport(Library, EntryPoint = "rillShapeSphere")] public static extern IntPtr ShapeSphere(float radius);
        [DllImport(Library, EntryPoint = "rillShapeCapsule")] public static extern IntPtr ShapeCapsule(float radius, float half, int axis);
        [DllImport(Library, EntryPoint = "rillShapeHull")] public static extern IntPtr ShapeHull(Vector3[] points, int count);

        [DllImport(Library, EntryPoint = "rillShapeMesh")]
        public static extern IntPtr ShapeMesh(Vector3[] points, int pointCount, int[] indices, int indexCount);

        [DllImport(Library, EntryPoint = "rillShapeDelete")] public static extern void ShapeDelete(IntPtr shape);

        [DllImport(Library, EntryPoint = "rillWorldNew")] public static extern IntPtr WorldNew();
        [DllImport(Library, EntryPoint = "rillWorldDelete")] public static extern void WorldDelete(IntPtr world);
        [DllImport(Library, EntryPoint = "rillWorldLayers")] public static extern void WorldLayers(IntPtr world, uint[] masks);
        [DllImport(Library, EntryPoint = "rillWorldIgnore")] public static extern void WorldIgnore(IntPtr world, int a, int b, int isIgnored);
        [DllImport(Library, EntryPoint = "rillWorldStep")] public static extern int WorldStep(IntPtr world, float time, float bounceThreshold);
        [DllImport(Library, EntryPoint = "rillWorldContacts")] public static extern void WorldContacts(IntPtr world, [Out] ContactData[] contacts);

        [DllImport(Library, EntryPoint = "rillColliderSet")]
        public static extern void ColliderSet(IntPtr world, int id, in ColliderData collider);

        [DllImport(Library, EntryPoint = "rillColliderRemove")] public static extern void ColliderRemove(IntPtr world, int id);

        [DllImport(Library, EntryPoint = "rillActorNew")] public static extern IntPtr ActorNew(IntPtr world, ActorKind kind);
        [DllImport(Library, EntryPoint = "rillActorDelete")] public static extern void ActorDelete(IntPtr world, IntPtr actor);

        [DllImport(Library, EntryPoint = "rillActorShapes")]
        public static extern void ActorShapes(IntPtr world, IntPtr actor, int count, IntPtr[] shapes, int[] colliders, BodyPose[] poses);

        [DllImport(Library, EntryPoint = "rillActorPose")] public static extern void ActorPose(IntPtr world, IntPtr actor, BodyPose pose);
        [DllImport(Library, EntryPoint = "rillBodySet")] public static extern void BodySet(IntPtr world, IntPtr actor, in BodyData input);
        [DllImport(Library, EntryPoint = "rillBodyGet")] public static extern void BodyGet(IntPtr actor, in BodyData before, out SolvedBody after);

        [DllImport(Library, EntryPoint = "rillOverlap")]
        public static extern int Overlap(IntPtr world, IntPtr shape, BodyPose pose, [Out] int[] ids, int capacity);

        [DllImport(Library, EntryPoint = "rillRay")]
        public static extern int Ray(IntPtr world, Vector3 origin, Vector3 direction, float distance, int hitsBackfaces, [Out] HitData[] hits,
            int capacity);

        [DllImport(Library, EntryPoint = "rillSweep")]
        public static extern int Sweep(IntPtr world, IntPtr shape, BodyPose from, Vector3 direction, float distance, [Out] HitData[] hits,
            int capacity);

        [DllImport(Library, EntryPoint = "rillPenetration")]
        public static extern int Penetration(IntPtr a, BodyPose poseA, IntPtr b, BodyPose poseB, out Vector3 direction, out float depth);

        [DllImport(Library, EntryPoint = "rillClosest")] public static extern Vector3 Closest(IntPtr shape, BodyPose pose, Vector3 point);

        [DllImport(Library, EntryPoint = "rillJointNew")]
        public static extern IntPtr JointNew(IntPtr world, IntPtr a, BodyPose frameA, IntPtr b, BodyPose frameB, int collides);

        [DllImport(Library, EntryPoint = "rillJointSet")] public static extern void JointSet(IntPtr joint, JointAxis[] axes);

        [DllImport(Library, EntryPoint = "rillJointGet")]
        public static extern void JointGet(IntPtr joint, out Vector3 force, out Vector3 torque, out float angle);

        [DllImport(Library, EntryPoint = "rillJointDelete")] public static extern void JointDelete(IntPtr world, IntPtr joint);
    }

    internal enum ActorKind { Static = 0, Body = 1, Trigger = 2 }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ColliderData
    {
        public int Body, Flags, Layer;
        public uint Includes, Excludes;
        public float StaticFriction, DynamicFriction, Bounciness;
        public int FrictionCombine, BounceCombine;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ContactData
    {
        public int ColliderA, ColliderB;
        public Vector3 Point, Normal;       // the normal points from B to A
        public float Separation, Impulse;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct BodyData
    {
        public BodyPose Pose;
        public Vector3 Velocity, AngularVelocity;
        public float Mass;
        public Vector3 Inertia, LinearFactor, AngularFactor;
        public float SleepThreshold, SweptRadius;
        public int IsKinematic;
        public BodyActivity Activity;
    }

    internal enum BodyActivity { Unchanged = 0, Awake = 1, Asleep = 2 }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SolvedBody
    {
        public BodyPose Pose;
        public Vector3 Velocity, AngularVelocity;
        public int IsChanged, IsAsleep;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct HitData
    {
        public int Collider;
        public float Distance;
        public Vector3 Point, Normal;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct JointAxis
    {
        public float Low, High, Bounciness, Spring, Damper, Target;
        public int IsDriven;
        public float Velocity, MaxForce;
    }
}
