using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>
    /// A rigid body: forces and torques are integrated here at each step (see <see cref="PhysicsWorld"/>), contacts and joints solved by
    /// Bullet in between.
    /// </summary>
    public partial class Rigidbody : Component
    {
        [NonSerialized] internal BodyState State;
        [NonSerialized] float m_Mass = 1f;

        internal override void OnActivated()
        {
            State.SetPose(transform.position, transform.rotation);
            PhysicsWorld.Bodies.Add(this);
            PhysicsWorld.ShapesVersion++;
        }

        internal override void OnDeactivated()
        {
            PhysicsWorld.Bodies.Remove(this);
            PhysicsWorld.ShapesVersion++;
            PhysicsWorld.Remove(this);
        }

        internal override void OnCopied(Component source) => CopiedProperties.Into(source, this);

        public float mass { get => m_Mass; set { m_Mass = Mathf.Max(value, 1e-7f); massVersion = 0; } }
        public float drag { get; set; }
        public float angularDrag { get; set; } = 0.05f;
        public bool useGravity { get; set; } = true;
        public bool isKinematic { get; set; }
        public bool detectCollisions { get; set; } = true;
        public RigidbodyConstraints constraints { get; set; }
        public RigidbodyInterpolation interpolation { get; set; }
        public CollisionDetectionMode collisionDetectionMode { get; set; }
        public float maxAngularVelocity { get; set; } = Physics.defaultMaxAngularSpeed;
        public float maxLinearVelocity { get; set; } = 1e16f;
        public float maxDepenetrationVelocity { get; set; } = Physics.defaultMaxDepenetrationVelocity;
        public float sleepThreshold { get; set; } = Physics.sleepThreshold;
        public int solverIterations { get; set; } = Physics.defaultSolverIterations;
        public int solverVelocityIterations { get; set; } = Physics.defaultSolverVelocityIterations;
        public LayerMask includeLayers { get; set; }
        public LayerMask excludeLayers { get; set; }

        public bool freezeRotation
        {
            get => (constraints & RigidbodyConstraints.FreezeRotation) == RigidbodyConstraints.FreezeRotation;
            set => constraints = value ? constraints | RigidbodyConstraints.FreezeRotation : constraints & ~RigidbodyConstraints.FreezeRotation;
        }

        public Vector3 velocity { get => State.Velocity; set { State.Velocity = value; WakeUp(); } }
        public Vector3 angularVelocity { get => State.AngularVelocity;
            set { State.AngularVelocity = Vector3.ClampMagnitude(value, maxAngularVelocity); WakeUp(); } }
        public Vector3 position { get { State.Follow(transform); return State.Position; } set => State.Teleport(transform, value, null); }
        public Quaternion rotation { get { State.Follow(transform); return State.Rotation; } set => State.Teleport(transform, null, value); }

        public void AddForce(Vector3 force) => AddForce(force, ForceMode.Force);
        public void AddForce(float x, float y, float z) => AddForce(new Vector3(x, y, z), ForceMode.Force);
        public void AddForce(float x, float y, float z, ForceMode mode) => AddForce(new Vector3(x, y, z), mode);

        /// <summary>Acts in the next fixed step.</summary>
        public void AddForce(Vector3 force, ForceMode mode)
        {
            if (isKinematic)
                return;
            switch (mode)
            {
                case ForceMode.Force: State.Force += force; break;
                case ForceMode.Acceleration: State.Force += force * m_Mass; break;
                case ForceMode.Impulse: State.VelocityChange += force / m_Mass; break;
                default: State.VelocityChange += force; break;
            }
            WakeUp();
        }

        public void AddRelativeForce(Vector3 force) => AddRelativeForce(force, ForceMode.Force);
        public void AddRelativeForce(Vector3 force, ForceMode mode) => AddForce(rotation * force, mode);
        public void AddRelativeForce(float x, float y, float z) => AddRelativeForce(new Vector3(x, y, z), ForceMode.Force);
        public void AddRelativeForce(float x, float y, float z, ForceMode mode) => AddRelativeForce(new Vector3(x, y, z), mode);

        public void AddTorque(Vector3 torque) => AddTorque(torque, ForceMode.Force);
        public void AddTorque(float x, float y, float z) => AddTorque(new Vector3(x, y, z), ForceMode.Force);
        public void AddTorque(float x, float y, float z, ForceMode mode) => AddTorque(new Vector3(x, y, z), mode);

        public void AddTorque(Vector3 torque, ForceMode mode)
        {
            if (isKinematic)
                return;
            switch (mode)
            {
                case ForceMode.Force: State.Torque += torque; break;
                case ForceMode.Acceleration: State.AngularAcceleration += torque; break;
                case ForceMode.Impulse: State.AngularVelocityChange += TurnedBy(torque); break;
                default: State.AngularVelocityChange += torque; break;
            }
            WakeUp();
        }

        public void AddRelativeTorque(Vector3 torque) => AddRelativeTorque(torque, ForceMode.Force);
        public void AddRelativeTorque(Vector3 torque, ForceMode mode) => AddTorque(rotation * torque, mode);
        public void AddRelativeTorque(float x, float y, float z) => AddRelativeTorque(new Vector3(x, y, z), ForceMode.Force);
        public void AddRelativeTorque(float x, float y, float z, ForceMode mode) => AddRelativeTorque(new Vector3(x, y, z), mode);

        public void AddForceAtPosition(Vector3 force, Vector3 position) => AddForceAtPosition(force, position, ForceMode.Force);

        public void AddForceAtPosition(Vector3 force, Vector3 position, ForceMode mode)
        {
            AddForce(force, mode);
            // Unity takes the lever as one of a force or an impulse: a change of velocity is one by way of the mass.
            bool byMass = mode == ForceMode.Acceleration || mode == ForceMode.VelocityChange;
            Vector3 torque = Vector3.Cross(position - worldCenterOfMass, byMass ? force * m_Mass : force);
            AddTorque(torque, mode == ForceMode.Force || mode == ForceMode.Acceleration ? ForceMode.Force : ForceMode.Impulse);
        }

        public Vector3 GetAccumulatedForce() => GetAccumulatedForce(Time.fixedDeltaTime);
        public Vector3 GetAccumulatedForce(float step) => State.Force + State.VelocityChange * (m_Mass / step);
        public Vector3 GetAccumulatedTorque() => GetAccumulatedTorque(Time.fixedDeltaTime);
        public Vector3 GetAccumulatedTorque(float step) => State.Torque + NeededFor(State.AngularAcceleration + State.AngularVelocityChange / step);

        public Vector3 GetPointVelocity(Vector3 worldPoint) => State.Velocity + Vector3.Cross(State.AngularVelocity, worldPoint - worldCenterOfMass);
        public Vector3 GetRelativePointVelocity(Vector3 relativePoint) => GetPointVelocity(position + rotation * relativePoint);

        public void MovePosition(Vector3 position) => State.MoveTo(transform, position, null);
        public void MoveRotation(Quaternion rot) => State.MoveTo(transform, null, rot);
        public void Move(Vector3 position, Quaternion rotation) => State.MoveTo(transform, position, rotation);

        /// <summary>Stands still until something moves it.</summary>
        public void Sleep()
        {
            State.Sleeps = true;
            State.Velocity = State.AngularVelocity = Vector3.zero;
            State.ForgetForces();
        }

        public bool IsSleeping() => State.Sleeps;

        public void WakeUp()
        {
            State.Sleeps = false;
            State.IsTouched = true;
        }

        /// <summary>Angular acceleration by a torque: the inverse of the inertia tensor times it.</summary>
        internal Vector3 TurnedBy(Vector3 torque) => ByAxes(torque, invert: true);

        Vector3 NeededFor(Vector3 angularAcceleration) => ByAxes(angularAcceleration, invert: false);

        Vector3 ByAxes(Vector3 value, bool invert)
        {
            Quaternion axes = State.Rotation * inertiaTensorRotation;
            Vector3 local = Quaternion.Inverse(axes) * value, inertia = inertiaTensor;
            for (int i = 0; i < 3; i++)
                local[i] = invert ? inertia[i] > 0f ? local[i] / inertia[i] : 0f : local[i] * inertia[i];
            return axes * local;
        }
    }

    public enum ForceMode { Force = 0, Impulse = 1, VelocityChange = 2, Acceleration = 5 }
    public enum RigidbodyInterpolation { None = 0, Interpolate = 1, Extrapolate = 2 }
    public enum CollisionDetectionMode { Discrete = 0, Continuous = 1, ContinuousDynamic = 2, ContinuousSpeculative = 3 }

    [Flags]
    public enum RigidbodyConstraints
    {
        None = 0,
        FreezePositionX = 2, FreezePositionY = 4, FreezePositionZ = 8,
        FreezeRotationX = 16, FreezeRotationY = 32, FreezeRotationZ = 64,
        FreezePosition = 14, FreezeRotation = 112, FreezeAll = 126,
    }
}
