using System;
using System.Linq;
using Rill.Tests;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Editor.Tests
{
    /// <summary>A pass of a project over the particles, Tests/Editor/Probes/ParticlePass.compute, in a fluid without frames.</summary>
    sealed class ParticlePass : IDisposable
    {
        public readonly SourceScene Scene;
        public readonly ComputeShader Shader = LayoutProbes.Load("ParticlePass");
        readonly GraphicsBuffer seen, neighbors;
        Action<CommandBuffer, FluidParticles> pass;

        public ParticlePass(SourceScene scene)
        {
            Scene = scene;
            seen = GpuBuffer.Structured<float4>("Seen", 3L * scene.Fluid.Capacity);
            neighbors = GpuBuffer.Structured<uint2>("Neighbors", scene.Fluid.Capacity);
        }

        /// <summary>A particle as a shader of a project reads it.</summary>
        public struct Particle
        {
            public float3 position, velocity, drawn;
            public uint id, phase;
        }

        public FluidParticles Particles => Scene.Fluid.TryGetParticles(out FluidParticles particles) ? particles
            : throw new InvalidOperationException("not running");

        /// <summary>Runs a kernel before each step from now on, instead of the last.</summary>
        public ParticlePass Before(string kernel, Vector3 center, float radius, Vector3 vector = default, int phase = 0)
        {
            End();
            pass = (commands, particles) => Record(commands, particles, kernel, center, radius, vector, phase);
            Scene.Fluid.BeforeStep += pass;
            return this;
        }

        public void End()
        {
            if (pass != null)
                Scene.Fluid.BeforeStep -= pass;
            pass = null;
        }

        public void Record(CommandBuffer commands, FluidParticles particles, string kernel, Vector3 center, float radius, Vector3 vector, int phase)
        {
            commands.SetComputeVectorParam(Shader, "_Ball", new Vector4(center.x, center.y, center.z, radius));
            commands.SetComputeVectorParam(Shader, "_Vector", vector);
            commands.SetComputeIntParam(Shader, "_Phase", phase);
            particles.Dispatch(commands, Shader, Shader.FindKernel(kernel));
        }

        /// <summary>The particles as a kernel sees them now, in the order of the buffers.</summary>
        public Particle[] See()
        {
            FluidParticles particles = Particles;
            int kernel = Shader.FindKernel("See");
            GpuTest.Run(cmd =>
            {
                cmd.SetComputeBufferParam(Shader, kernel, "_Seen", seen);
                particles.Dispatch(cmd, Shader, kernel);
            });
            int count = (int)GpuTest.Read<uint>(particles.Counts, 1)[0];
            float4[] words = GpuTest.Read<float4>(seen, 3 * count);
            return Enumerable.Range(0, count).Select(i => new Particle
            {
                position = words[3 * i].xyz,
                phase = (uint)words[3 * i].w,
                velocity = words[3 * i + 1].xyz,
                id = math.asuint(words[3 * i + 1].w),
                drawn = words[3 * i + 2].xyz,
            }).ToArray();
        }

        /// <summary>Returns for each particle the number of others within a radius and the sum of their ids, by the look-up of the include.</summary>
        public uint2[] Neighbors(float radius)
        {
            FluidParticles particles = Particles;
            int kernel = Shader.FindKernel("CountNeighbors");
            GpuTest.Run(cmd =>
            {
                particles.SortNeighbors(cmd);
                cmd.SetComputeFloatParam(Shader, "_Radius", radius);
                cmd.SetComputeBufferParam(Shader, kernel, "_Neighbors", neighbors);
                particles.Dispatch(cmd, Shader, kernel);
            });
            return GpuTest.Read<uint2>(neighbors, (int)GpuTest.Read<uint>(particles.Counts, 1)[0]);
        }

        public void Dispose()
        {
            End();
            seen.Release();
            neighbors.Release();
        }
    }
}
