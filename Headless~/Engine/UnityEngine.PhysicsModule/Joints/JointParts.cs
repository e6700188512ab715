namespace UnityEngine
{
    /// <summary>Degrees.</summary>
    public struct JointLimits
    {
        public float min { get; set; }
        public float max { get; set; }
        public float bounciness { get; set; }
        public float bounceMinVelocity { get; set; }
        public float contactDistance { get; set; }
    }

    /// <summary>Degrees a second and N m.</summary>
    public struct JointMotor
    {
        public float targetVelocity { get; set; }
        public float force { get; set; }
        public bool freeSpin { get; set; }
    }

    /// <summary>N m a radian, N m s, degrees.</summary>
    public struct JointSpring
    {
        public float spring, damper, targetPosition;
    }
}
