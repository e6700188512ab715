using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What of a fluid is drawn in a frame, for all cameras.</summary>
    struct SurfaceFrame
    {
        const float FilterRange = 2f;       // d

        /// <summary>Differs once the particles have changed.</summary>
        public int version;

        /// <summary>FluidSimulation.FrameLag.</summary>
        public Vector4 lag;

        public Matrix4x4 domainToWorld;

        /// <summary>At the frame before.</summary>
        public Matrix4x4 lastDomainToWorld;

        /// <summary>d.</summary>
        public Vector3 domainSize;

        /// <summary>Particle spacing, m.</summary>
        public float spacing;

        /// <summary>Two standard deviations of the filter on the picture, and half of the depth around a texel that it takes in; world, m.</summary>
        public float filterRadius, filterRange;

        /// <summary>How often the filter runs, at least 1.</summary>
        public int filterPasses;

        /// <summary>Width of the textures over that of the screen, up to 1.</summary>
        public float scale;

        /// <summary>The ellipsoids of SurfaceParticle.hlsl and the arguments of their draw.</summary>
        public GraphicsBuffer surfaceParticles, surfaceArguments;

        /// <summary>The buffers of DrawnParticles.hlsl and the arguments of a draw of all particles.</summary>
        public GraphicsBuffer positions, startPositions, velocities, counters, particleArguments;

        /// <summary>None where its buffers are null.</summary>
        public FoamFrame foam;

        /// <summary>Those with a look of their own.</summary>
        public PhaseFrame phases;

        /// <summary>Sets what DrawnSurface.hlsl reads.</summary>
        public readonly void SetOn(MaterialPropertyBlock block)
        {
            block.SetMatrix(Ids.DomainToWorld, domainToWorld);
            block.SetVector(Ids.FrameLag, lag);
            block.SetVector(Ids.DrawnDomainSize, domainSize);
            block.SetBuffer(Ids.SurfaceParticles, surfaceParticles);
        }

        /// <summary>Sets the domain's pose, its size and the time of the frame.</summary>
        public readonly void SetOn(CommandBuffer cmd, ComputeShader shader)
        {
            cmd.SetComputeMatrixParam(shader, Ids.DomainToWorld, domainToWorld);
            cmd.SetComputeVectorParam(shader, Ids.FrameLag, lag);
            cmd.SetComputeVectorParam(shader, Ids.DrawnDomainSize, domainSize);
        }

        /// <summary>The fluid's box alone, before there is a surface.</summary>
        public static SurfaceFrame BoxOf(FluidSimulation fluid) => new SurfaceFrame
        {
            domainToWorld = fluid.DomainToWorld, domainSize = fluid.DomainSize / fluid.ParticleSpacing, spacing = fluid.ParticleSpacing,
        };

        /// <param name="smoothing">Two standard deviations of the filter on the picture, d.</param>
        public static SurfaceFrame Of(PbfSolver solver, Matrix4x4 domainToWorld, Vector4 lag, float smoothing, SurfaceQuality quality)
        {
            float spacing = solver.Layout.Spacing;
            return new SurfaceFrame
            {
                version = solver.SurfaceVersion, lag = lag, domainToWorld = domainToWorld, lastDomainToWorld = domainToWorld,
                domainSize = solver.Layout.DomainSize, spacing = spacing,
                filterRadius = smoothing * spacing, filterRange = FilterRange * spacing,
                filterPasses = quality == SurfaceQuality.High ? 2 : 1, scale = quality == SurfaceQuality.Low ? 0.5f : 1f,
                surfaceParticles = solver.Surface.Particles, surfaceArguments = solver.Surface.Arguments,
                positions = solver.Positions, startPositions = solver.StartPositions, velocities = solver.Velocities, counters = solver.Counters,
                particleArguments = solver.DrawArguments,
            };
        }

        static class Ids
        {
            public static readonly int DomainToWorld = Shader.PropertyToID("_DomainToWorld");
            public static readonly int FrameLag = Shader.PropertyToID("_FrameLag");
            public static readonly int DrawnDomainSize = Shader.PropertyToID("_DrawnDomainSize");
            public static readonly int SurfaceParticles = Shader.PropertyToID("_SurfaceParticles");
        }
    }
}
