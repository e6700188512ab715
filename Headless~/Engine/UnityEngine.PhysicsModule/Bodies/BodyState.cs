namespace UnityEngine.Headless
{
    /// <summary>Pose and motion of a body, and what acts on it in the coming step. Its object shows a pose between the last two steps
    /// where the body interpolates.</summary>
    internal struct BodyState
    {
        public Vector3 Position, Velocity, AngularVelocity;
        public Quaternion Rotation;
        public Vector3 Force, VelocityChange, Torque, AngularAcceleration, AngularVelocityChange;
        public bool Sleeps;

        /// <summary>Since the last step something has acted on it or moved it.</summary>
        public bool IsTouched;

        Vector3 lastPosition, shownPosition;
        Quaternion lastRotation, shownRotation;
        Vector3? wantedPosition;
        Quaternion? wantedRotation;
        bool isTeleported;      // since the last step, and its object is where it was

        public BodyPose Pose => new BodyPose(Position, Rotation);

        /// <summary>Contacts moved it out of what it had sunk into.</summary>
        public void Push(in BodyPose pose)
        {
            Position = pose.Position;
            Rotation = pose.Rotation;
        }

        public void SetPose(Vector3 position, Quaternion rotation)
        {
            Position = lastPosition = shownPosition = position;
            Rotation = lastRotation = shownRotation = rotation;
            isTeleported = false;
        }

        /// <summary>Motions of the object by others than its body move the body.</summary>
        public void Follow(Transform transform)
        {
            if (!transform.position.Equals(shownPosition) || !transform.rotation.Equals(shownRotation))
            {
                SetPose(transform.position, transform.rotation);
                IsTouched = true;
            }
        }

        /// <summary>Puts the body elsewhere; as in Unity, its object follows with the next step.</summary>
        public void Teleport(Transform transform, Vector3? position, Quaternion? rotation)
        {
            Follow(transform);
            Position = lastPosition = position ?? Position;
            Rotation = lastRotation = rotation ?? Rotation;
            isTeleported = IsTouched = true;
        }

        public void MoveTo(Transform transform, Vector3? position, Quaternion? rotation)
        {
            Follow(transform);
            wantedPosition = position ?? wantedPosition;
            wantedRotation = rotation ?? wantedRotation;
        }

        public void ForgetForces() => Force = VelocityChange = Torque = AngularAcceleration = AngularVelocityChange = Vector3.zero;

        /// <summary>Scripts of a fixed step find the object where the body is.</summary>
        public void ShowBody(Transform transform)
        {
            Follow(transform);
            Show(transform, Position, Rotation);
        }

        public void ShowBetween(Transform transform, float fraction)
        {
            if (!isTeleported)
                Show(transform, Vector3.Lerp(lastPosition, Position, fraction), Quaternion.Slerp(lastRotation, Rotation, fraction));
        }

        void Show(Transform transform, Vector3 position, Quaternion rotation)
        {
            transform.SetPositionAndRotation(position, rotation);
            Remember(transform);
        }

        // Remembers the pose as it comes back from the hierarchy, rounded.
        void Remember(Transform transform)
        {
            shownPosition = transform.position;
            shownRotation = transform.rotation;
        }

        /// <summary>The first half of a step: velocities by what acts, less drag. A kinematic body is moved by MovePosition and MoveRotation
        /// alone; its velocities are those of the displacement.</summary>
        public void Accelerate(Rigidbody body, float time)
        {
            lastPosition = Position;
            lastRotation = Rotation;
            if (body.isKinematic)
                AccelerateKinematic(time);
            else if (!Sleeps)
                AccelerateFree(body, time);
            ForgetForces();
        }

        void AccelerateKinematic(float time)
        {
            Velocity = ((wantedPosition ?? Position) - Position) / time;
            ((wantedRotation ?? Rotation) * Quaternion.Inverse(Rotation)).ToAngleAxis(out float angle, out Vector3 axis);
            AngularVelocity = Mathf.Abs(angle) > 1e-4f ? axis * ((angle > 180f ? angle - 360f : angle) * Mathf.Deg2Rad / time) : Vector3.zero;
        }

        void AccelerateFree(Rigidbody body, float time)
        {
            Vector3 acceleration = Force / body.mass + (body.useGravity ? PhysicsWorld.Gravity : Vector3.zero);
            Velocity = (Velocity + acceleration * time + VelocityChange) * Mathf.Max(1f - body.drag * time, 0f);
            AngularVelocity = (AngularVelocity + (body.TurnedBy(Torque) + AngularAcceleration) * time + AngularVelocityChange)
                * Mathf.Max(1f - body.angularDrag * time, 0f);
            Limit(body);
        }

        /// <summary>The second half, after contacts and joints were solved: places by the new velocities (semi-implicit Euler).</summary>
        public void Move(Rigidbody body, float time)
        {
            if (body.isKinematic)
            {
                Position = wantedPosition ?? Position;
                Rotation = wantedRotation ?? Rotation;
            }
            else if (!Sleeps)
                MoveFree(body, time);
            wantedPosition = null;
            wantedRotation = null;
            isTeleported = false;
        }

        void MoveFree(Rigidbody body, float time)
        {
            Vector3 center = body.centerOfMass;
            Vector3 position = (wantedPosition ?? Position) + (wantedRotation ?? Rotation) * center + Velocity * time;
            float angle = AngularVelocity.magnitude * time;
            Rotation = wantedRotation ?? Rotation;
            if (angle > 0f)
                Rotation = (Quaternion.AngleAxis(angle * Mathf.Rad2Deg, AngularVelocity) * Rotation).normalized;
            Position = position - Rotation * center;
        }

        /// <summary>Keeps velocities within the body's limits and constraints.</summary>
        public void Limit(Rigidbody body)
        {
            Velocity = Vector3.ClampMagnitude(Velocity, body.maxLinearVelocity);
            AngularVelocity = Vector3.ClampMagnitude(AngularVelocity, body.maxAngularVelocity);
            Freeze(body.constraints);
        }

        void Freeze(RigidbodyConstraints constraints)
        {
            if (constraints == RigidbodyConstraints.None)
                return;
            for (int axis = 0; axis < 3; axis++)
            {
                if (((int)constraints & (int)RigidbodyConstraints.FreezePositionX << axis) != 0)
                    Velocity[axis] = 0f;
                if (((int)constraints & (int)RigidbodyConstraints.FreezeRotationX << axis) != 0)
                    AngularVelocity[axis] = 0f;
            }
        }
    }
}
