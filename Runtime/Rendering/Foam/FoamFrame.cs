using UnityEngine;

namespace Rill
{
    /// <summary>Foam of a fluid that is drawn in a frame, for all cameras.</summary>
    struct FoamFrame
    {
        /// <summary>FoamParticle, see Foam.hlsl; null without foam.</summary>
        public GraphicsBuffer particles;

        /// <summary>By <see cref="FoamCounter"/>.</summary>
        public GraphicsBuffer counters;

        /// <summary>Arguments of a draw of the particles and a dispatch over them, see <see cref="GpuBuffer.Arguments"/>.</summary>
        public GraphicsBuffer arguments;

        /// <summary>x radius of the largest, m; y how much nearer to the eye a draw without surface puts them, m; z opacity;
        /// w time of exposure, s.</summary>
        public Vector4 look;

        /// <summary>Color as shaders need it.</summary>
        public Vector4 color;
    }
}
