using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>Turns about its axis alone.</summary>
    public class HingeJoint : Joint
    {
        [NonSerialized] JointLimits m_Limits;
        [NonSerialized] JointMotor m_Motor;
        [NonSerialized] JointSpring m_Spring;
        [NonSerialized] bool m_UseLimits, m_UseMotor, m_UseSpring;

        public JointLimits limits { get => m_Limits; set { m_Limits = value; Changed(); } }
        public JointMotor motor { get => m_Motor; set { m_Motor = value; Changed(); } }
        public JointSpring spring { get => m_Spring; set { m_Spring = value; Changed(); } }
        public bool useLimits { get => m_UseLimits; set { m_UseLimits = value; Changed(); } }
        public bool useMotor { get => m_UseMotor; set { m_UseMotor = value; Changed(); } }
        public bool useSpring { get => m_UseSpring; set { m_UseSpring = value; Changed(); } }

        /// <summary>Held alone.</summary>
        public bool extendedLimits { get; set; }
        public bool useAcceleration { get; set; }

        /// <summary>From where it was first stepped, degrees.</summary>
        public float angle => Angle * Mathf.Rad2Deg;

        /// <summary>Degrees a second.</summary>
        public float velocity
        {
            get
            {
                Vector3 between = Body != null ? Body.angularVelocity : Vector3.zero;
                if (connectedBody != null)
                    between -= connectedBody.angularVelocity;
                return Vector3.Dot(between, transform.rotation * axis.normalized) * Mathf.Rad2Deg;
            }
        }

        private protected override void CopyMore(Joint copy)
        {
            var hinge = (HingeJoint)copy;
            (hinge.m_Limits, hinge.m_Motor, hinge.m_Spring) = (m_Limits, m_Motor, m_Spring);
            (hinge.m_UseLimits, hinge.m_UseMotor, hinge.m_UseSpring) = (m_UseLimits, m_UseMotor, m_UseSpring);
        }

        private protected override bool Describe(JointAxis[] axes)
        {
            Array.Clear(axes, 0, axes.Length);
            ref JointAxis turn = ref axes[3];
            (turn.Low, turn.High) = m_UseLimits ? (m_Limits.min * Mathf.Deg2Rad, m_Limits.max * Mathf.Deg2Rad) : (1f, -1f);
            turn.Bounciness = m_UseLimits ? m_Limits.bounciness : 0f;
            if (m_UseMotor)
                (turn.IsDriven, turn.Velocity, turn.MaxForce) = (1, m_Motor.targetVelocity * Mathf.Deg2Rad, m_Motor.force);
            else if (m_UseSpring)
                (turn.Spring, turn.Damper, turn.Target) = (m_Spring.spring, m_Spring.damper, m_Spring.targetPosition * Mathf.Deg2Rad);
            return true;
        }
    }
}
