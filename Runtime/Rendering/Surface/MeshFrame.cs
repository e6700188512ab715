using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The mesh of a fluid's surface in a frame, for all cameras; see MeshVertex.hlsl and MeshField.hlsl.</summary>
    struct MeshFrame
    {
        const int FineLines = 1440;
        const float MaxSlope = 0.15f, RippleLife = 0.5f;    // s
        const float MinGravity = 1f;        // m/s^2
        const double MaxLives = 4096.0;     // then the same patterns come again: a float has no room for more

        /// <summary>28 bytes a vertex, raw; three 32-bit indices a triangle, raw too.</summary>
        public GraphicsBuffer vertices, indices;

        /// <summary>Begins with a GraphicsBuffer.IndirectDrawIndexedArgs of one instance.</summary>
        public GraphicsBuffer arguments;

        /// <summary>A word for each brick of the domain.</summary>
        public GraphicsBuffer top;

        /// <summary>The nodes of those bricks that the surface is near, and the size of a texel of this texture.</summary>
        public Texture field;
        public Vector4 fieldTexel;

        /// <summary>The elements of SurfaceElement.hlsl, the indices of those that are drops, and SurfaceMesh.Counters; null where there are
        /// none.</summary>
        public GraphicsBuffer elements, drops, counters;

        /// <summary>None where its buffers are null.</summary>
        public FoamFrame foam;

        /// <summary>Null where all phases look alike.</summary>
        public PhaseGrid phases;

        /// <summary>Null without caustics.</summary>
        public CausticMap caustics;

        /// <summary>Length of the exposure in substeps: what flies is drawn out by so many displacements.</summary>
        public float exposure;

        /// <summary>Distance between nodes, d.</summary>
        public float cell;

        /// <summary>Bricks of the domain along each axis.</summary>
        public Vector3Int bricks;

        /// <summary>From the domain's frame in d to the world.</summary>
        public Matrix4x4 domainToWorld;

        /// <summary>At the frame before.</summary>
        public Matrix4x4 lastDomainToWorld;

        /// <summary>d.</summary>
        public Vector3 domainSize;

        /// <summary>Particle spacing, m.</summary>
        public float spacing;

        /// <summary>Width of the textures of faces over that of the picture, up to 1.</summary>
        public float rayScale;

        /// <summary>Most texels from the bottom to the top of a picture up to which rays and spray have textures as wide as those of faces. Above
        /// that theirs have half the width, above twice as many a quarter.</summary>
        public int fineLines;

        /// <summary>See Ripples.hlsl; 0 for none.</summary>
        public Vector4 ripples;

        /// <summary>Up in the domain's frame.</summary>
        public Vector3 rippleUp;

        /// <summary><see cref="FluidClock.FrameLag"/>.</summary>
        public Vector4 lag;

        /// <summary>World, of all that is drawn.</summary>
        public Bounds bounds;

        /// <summary>The box alone.</summary>
        public readonly FluidBox Box => new FluidBox(domainToWorld, domainSize, spacing);

        public readonly bool HasFoam => foam.particles != null;

        /// <summary>Whether there is anything that the mesh does not hold.</summary>
        public readonly bool HasSpray => drops != null || HasFoam;

        /// <summary>The mesh that a running fluid has found, at the time of this frame.</summary>
        public static MeshFrame Of(FluidSimulation fluid, SurfaceMesh found, SurfaceQuality quality = SurfaceQuality.Medium)
        {
            PbfSolver solver = fluid.Solver;
            Vector3 box = fluid.DomainSize;
            float spacing = fluid.ParticleSpacing;
            return new MeshFrame
            {
                vertices = found.Vertices, indices = found.Indices, arguments = found.Arguments, top = found.Top, field = found.Field,
                fieldTexel = new Vector4(1f / found.Field.width, 1f / found.Field.height, 1f / found.Field.volumeDepth),
                elements = solver.Surface.Particles, drops = found.Drops, counters = found.Counters,
                exposure = 0.5f * solver.LastSubsteps,
                cell = found.Cell, bricks = new Vector3Int(found.Bricks.x, found.Bricks.y, found.Bricks.z),
                domainToWorld = fluid.DomainToWorld, lastDomainToWorld = fluid.DomainToWorld,
                domainSize = box / spacing, spacing = spacing, lag = fluid.Clock.FrameLag,
                rayScale = quality == SurfaceQuality.Low ? 0.5f : 1f, fineLines = quality == SurfaceQuality.High ? int.MaxValue : FineLines,
                bounds = new Bounds(fluid.DomainToWorld.MultiplyPoint3x4(box * (0.5f / spacing)), Vector3.one * (box.magnitude + 4f * spacing)),
            };
        }

        /// <summary>Sets ripples on water that moves.</summary>
        /// <param name="height">0 to 1.</param>
        public void SetRipples(FluidSimulation fluid, float height)
        {
            float gravity = fluid.Gravity.magnitude, substep = fluid.FixedStep / Mathf.Max(fluid.Solver.LastSubsteps, 1);
            float fast = Mathf.Sqrt(Mathf.Max(gravity, MinGravity) * spacing) / spacing;        // d/s
            ripples = new Vector4(height * MaxSlope, (float)(fluid.FrameTime / RippleLife % MaxLives), RippleLife / substep,
                1f / (fast * substep));
            rippleUp = gravity > 0f ? domainToWorld.inverse.MultiplyVector(fluid.Gravity / -gravity).normalized : Vector3.zero;
        }

        /// <summary>Sets what the water's shaders read.</summary>
        public readonly void SetOn(MaterialPropertyBlock block)
        {
            block.SetBuffer(DrawnIds.MeshVertices, vertices);
            block.SetBuffer(Ids.MeshTop, top);
            block.SetTexture(Ids.MeshField, field);
            block.SetVector(Ids.MeshFieldTexel, fieldTexel);
            if (drops != null)
            {
                block.SetBuffer(Ids.SurfaceElements, elements);
                block.SetBuffer(Ids.MeshDrops, drops);
                block.SetVector(Ids.FrameExposure, new Vector4(exposure, 0f, 0f, 0f));
            }
            block.SetFloat(Ids.MeshCell, cell);
            block.SetVector(Ids.MeshBricks, (Vector3)bricks);
            block.SetMatrix(DrawnIds.DomainToWorld, domainToWorld);
            block.SetMatrix(DrawnIds.WorldToDomain, domainToWorld.inverse);
            block.SetVector(DrawnIds.DrawnDomainSize, domainSize);
            block.SetVector(DrawnIds.FrameLag, lag);
        }

        /// <summary>Sets what DrawnDomain.hlsl and MeshField.hlsl read, but for the field.</summary>
        public readonly void SetOn(CommandBuffer cmd, ComputeShader shader)
        {
            cmd.SetComputeFloatParam(shader, Ids.MeshCell, cell);
            cmd.SetComputeVectorParam(shader, Ids.MeshFieldTexel, fieldTexel);
            cmd.SetComputeVectorParam(shader, Ids.MeshBricks, (Vector3)bricks);
            cmd.SetComputeMatrixParam(shader, DrawnIds.DomainToWorld, domainToWorld);
            cmd.SetComputeMatrixParam(shader, DrawnIds.WorldToDomain, domainToWorld.inverse);
            cmd.SetComputeVectorParam(shader, DrawnIds.DrawnDomainSize, domainSize);
            cmd.SetComputeVectorParam(shader, DrawnIds.FrameLag, lag);
            cmd.SetComputeVectorParam(shader, Ids.Ripples, ripples);
            cmd.SetComputeVectorParam(shader, Ids.RippleUp, rippleUp);
        }

        /// <summary>Sets what Droplets.hlsl reads for a kernel.</summary>
        public readonly void SetDrops(CommandBuffer cmd, ComputeShader shader, int kernel)
        {
            cmd.SetComputeBufferParam(shader, kernel, Ids.SurfaceElements, elements);
            cmd.SetComputeBufferParam(shader, kernel, Ids.MeshDrops, drops);
            cmd.SetComputeBufferParam(shader, kernel, DrawnIds.MeshCounters, counters);
            cmd.SetComputeIntParam(shader, Ids.DropCapacity, drops.count);
            cmd.SetComputeVectorParam(shader, Ids.FrameExposure, new Vector4(exposure, 0f, 0f, 0f));
        }

        /// <summary>Sets the field for a kernel.</summary>
        public readonly void SetField(CommandBuffer cmd, ComputeShader shader, int kernel)
        {
            cmd.SetComputeBufferParam(shader, kernel, Ids.MeshTop, top);
            cmd.SetComputeTextureParam(shader, kernel, Ids.MeshField, field);
        }

        static class Ids
        {
            public static readonly int MeshTop = Shader.PropertyToID("_MeshTop");
            public static readonly int MeshField = Shader.PropertyToID("_MeshField");
            public static readonly int MeshFieldTexel = Shader.PropertyToID("_MeshFieldTexel");
            public static readonly int SurfaceElements = Shader.PropertyToID("_SurfaceElements");
            public static readonly int MeshDrops = Shader.PropertyToID("_MeshDrops");
            public static readonly int DropCapacity = Shader.PropertyToID("_DropCapacity");
            public static readonly int FrameExposure = Shader.PropertyToID("_FrameExposure");
            public static readonly int MeshCell = Shader.PropertyToID("_MeshCell");
            public static readonly int MeshBricks = Shader.PropertyToID("_MeshBricks");
            public static readonly int Ripples = Shader.PropertyToID("_Ripples");
            public static readonly int RippleUp = Shader.PropertyToID("_RippleUp");
        }
    }
}
