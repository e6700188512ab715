using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>Holds the other body where it is against this one.</summary>
    public class FixedJoint : Joint
    {
        private protected override bool Describe(JointAxis[] axes)
        {
            Array.Clear(axes, 0, axes.Length);
            return true;
        }
    }
}
