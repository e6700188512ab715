using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>
    /// Draws its anchors together or apart until their distance is between two limits. Solved here before the contacts, as a soft constraint
    /// that is stable with any stiffness (Catto, "Soft Constraints", GDC 2011).
    /// </summary>
    public class SpringJoint : Joint
    {
        /// <summary>N/m.</summary>
        public float spring { get; set; } = 10f;

        /// <summary>N s/m.</summary>
        public float damper { get; set; } = 0.2f;

        /// <summary>m, over the distance at the start.</summary>
        public float minDistance { get; set; }
        public float maxDistance { get; set; }
        public float tolerance { get; set; } = 0.025f;

        internal override void Prepare(ContactWorld world, float time)
        {
            Rigidbody own = Body, other = connectedBody;
            if (own == null || other != null && !other.Activated)
                return;
            if (!IsSettled)
                Settle();
            Vector3 here = own.State.Pose.Of(new BodyPose(Vector3.Scale(anchor, transform.lossyScale), Quaternion.identity)).Position;
            Vector3 there = other != null ? other.State.Pose.Of(new BodyPose(Vector3.Scale(connectedAnchor, other.transform.lossyScale),
                Quaternion.identity)).Position : connectedAnchor;
            float distance = Vector3.Distance(here, there),
                error = distance - Mathf.Clamp(distance, minDistance, Mathf.Max(minDistance, maxDistance));
            currentForce = Vector3.zero;
            if (distance < 1e-6f || Mathf.Abs(error) <= 0f)
                return;
            Vector3 along = (here - there) / distance;
            float stiffness = time * (damper + time * spring);
            if (stiffness <= 0f)
                return;
            float softness = 1f / stiffness, speed = Vector3.Dot(along,
                own.GetPointVelocity(here) - (other != null ? other.GetPointVelocity(there) : Vector3.zero));
            float inverse = Ease(own, here, along) + (other != null ? Ease(other, there, along) : 0f);
            float impulse = -(speed + error * time * spring * softness) / (inverse + softness);
            Push(own, here, along * impulse);
            if (other != null)
                Push(other, there, along * -impulse);
            currentForce = along * (impulse / time);
        }

        // Change of velocity at a point by an impulse of 1 along a direction.
        static float Ease(Rigidbody body, Vector3 point, Vector3 along)
        {
            if (body.isKinematic)
                return 0f;
            Vector3 arm = Vector3.Cross(point - body.worldCenterOfMass, along);
            return 1f / body.mass + Vector3.Dot(arm, body.TurnedBy(arm));
        }

        static void Push(Rigidbody body, Vector3 point, Vector3 impulse)
        {
            if (body.isKinematic)
                return;
            body.State.Velocity += impulse / body.mass;
            body.State.AngularVelocity += body.TurnedBy(Vector3.Cross(point - body.worldCenterOfMass, impulse));
            body.State.Limit(body);
            body.WakeUp();
        }
    }
}
