namespace UnityEngine.Headless
{
    /// <summary>Where a body is, how it moves, what acts on it in the coming step. Its object shows a place between the last two steps
    /// where the body interpolates.</summary>
    internal struct BodyState
    {
        public Vector3 Position, Velocity, AngularVelocity;
        public Quaternion Rotation;
        public Vector3 Force, VelocityChange, Torque, AngularAcceleration, AngularVelocityChange;
        public bool Sleeps;

        Vector3 lastPosition, shownPosition;
        Quaternion lastRotation, shownRotation;
        Vector3? wantedPosition;
        Quaternion? wantedRotation;

        public void SetPose(Vector3 position, Quaternion rotation)
        {
            Position = lastPosition = shownPosition = position;
            Rotation = lastRotation = shownRotation = rotation;
        }

        /// <summary>What moved the object other than its body moved the body.</summary>
        public void Follow(Transform transform)
        {
            if (!transform.position.Equals(shownPosition) || !transform.rotation.Equals(shownRotation))
                SetPose(transform.position, transform.rotation);
        }

        public void Teleport(Transform transform, Vector3 position, Quaternion rotation)
        {
            SetPose(position, rotation);
            transform.SetPositionAndRotation(position, rotation);
            Remember(transform);
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
            => Show(transform, Vector3.Lerp(lastPosition, Position, fraction), Quaternion.Slerp(lastRotation, Rotation, fraction));

        void Show(Transform transform, Vector3 position, Quaternion rotation)
        {
            transform.SetPositionAndRotation(position, rotation);
            Remember(transform);
        }

        // As it comes back from the hierarchy, rounded.
        void Remember(Transform transform)
        {
            shownPosition = transform.position;
            shownRotation = transform.rotation;
        }

        public void Step(Rigidbody body, float time)
        {
            lastPosition = Position;
            lastRotation = Rotation;
            if (body.isKinematic)
                StepKinematic(time);
            else if (!Sleeps)
                StepFree(body, time);
            ForgetForces();
            wantedPosition = null;
            wantedRotation = null;
        }

        // Moved by MovePosition and MoveRotation alone; the velocities are those of the displacement.
        void StepKinematic(float time)
        {
            Position = wantedPosition ?? Position;
            Rotation = wantedRotation ?? Rotation;
            Velocity = (Position - lastPosition) / time;
            (Rotation * Quaternion.Inverse(lastRotation)).ToAngleAxis(out float angle, out Vector3 axis);
            AngularVelocity = Mathf.Abs(angle) > 1e-4f ? axis * ((angle > 180f ? angle - 360f : angle) * Mathf.Deg2Rad / time) : Vector3.zero;
        }

        // Semi-implicit Euler: velocities by what acts, less drag, then places by the new velocities.
        void StepFree(Rigidbody body, float time)
        {
            Vector3 acceleration = Force / body.mass + (body.useGravity ? PhysicsWorld.Gravity : Vector3.zero);
            Velocity = (Velocity + acceleration * time + VelocityChange) * Mathf.Max(1f - body.drag * time, 0f);
            Velocity = Vector3.ClampMagnitude(Velocity, body.maxLinearVelocity);
            AngularVelocity = (AngularVelocity + (body.TurnedBy(Torque) + AngularAcceleration) * time + AngularVelocityChange)
                * Mathf.Max(1f - body.angularDrag * time, 0f);
            AngularVelocity = Vector3.ClampMagnitude(AngularVelocity, body.maxAngularVelocity);
            Freeze(body.constraints);

            Vector3 center = body.centerOfMass;
            Vector3 place = (wantedPosition ?? Position) + (wantedRotation ?? Rotation) * center + Velocity * time;
            float angle = AngularVelocity.magnitude * time;
            Rotation = wantedRotation ?? Rotation;
            if (angle > 0f)
                Rotation = (Quaternion.AngleAxis(angle * Mathf.Rad2Deg, AngularVelocity) * Rotation).normalized;
            Position = place - Rotation * center;
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
