using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // Another spacing or capacity while the fluid runs: a new solver gets the water of the old one. The fluid's time stands until that has come.
    public sealed partial class FluidSimulation
    {
        sealed class Resampling
        {
            public float spacing;
            public int capacity;
            public SnapshotContents water;
            public string problem;
            public bool isDone, isStale;
        }

        Resampling resampling;

        /// <summary>Whether the water is on its way to another spacing or capacity.</summary>
        internal bool IsResampling => resampling != null;

        void ChangeResolution(float spacing, int particles)
        {
            bool keeps = pbf != null && !IsInEditMode && playback == null && !layoutChanged && IsPossible(spacing, particles);
            if (!keeps)
            {
                ConfigureIfOther(domainSize, spacing, particles);
                return;
            }
            if (spacing == (resampling?.spacing ?? particleSpacing) && particles == (resampling?.capacity ?? capacity))
                return;
            resampling = new Resampling { spacing = spacing, capacity = particles };
            RequestWater(resampling);
        }

        bool IsPossible(float spacing, int particles)
        {
            try
            {
                return ProblemOnDevice(new SolverLayout(domainSize, spacing, particles, solver.neighborCapacity, solver.listMargin)) == null;
            }
            catch (ArgumentException)
            {
                return false;       // which it says as it begins again
            }
        }

        void RequestWater(Resampling of)
        {
            of.isDone = of.isStale = false;
            pbf.CaptureParticles().Request((water, problem) =>
            {
                of.water = water;
                of.problem = problem;
                of.isDone = true;
            });
        }

        // Before the steps of a frame.
        void FinishResampling()
        {
            if (resampling == null || !resampling.isDone)
                return;
            if (resampling.isStale)     // scripts changed the water meanwhile
            {
                RequestWater(resampling);
                return;
            }
            Resampling done = resampling;
            resampling = null;
            if (done.problem != null)
            {
                Debug.LogError($"Rill: FluidSimulation '{name}' {KeepsResolution}: {done.problem}", this);
                return;
            }
            GetPose(out _, out Quaternion rotation);
            var resampler = new WaterResampler(done.water.Values<float4>(SnapshotSection.Positions),
                done.water.Values<float4>(SnapshotSection.Velocities), done.water.Values<uint>(SnapshotSection.Tags),
                particleSpacing / done.spacing, (float3)domainSize / done.spacing,
                math.normalizesafe((float3)(Quaternion.Inverse(rotation) * gravity)), colliders.Set);
            if (resampler.Wanted > done.capacity)
            {
                Debug.LogError(Invariant($"Rill: FluidSimulation '{name}' {KeepsResolution}: its water is {resampler.Wanted:N0} particles at ") +
                    Invariant($"a spacing of {done.spacing} m, more than the capacity of {done.capacity:N0}. Raise the capacity first, or ") +
                    "remove water.", this);
                return;
            }
            Switch(done, resampler);
        }

        string KeepsResolution => Invariant($"keeps its particle spacing of {particleSpacing} m and its capacity of {capacity:N0}");

        void Switch(Resampling to, WaterResampler resampler)
        {
            float4[] positions, velocities;
            uint[] tags;
            if (to.spacing == particleSpacing)      // another capacity alone
                resampler.Copy(out positions, out velocities, out tags);
            else
                resampler.Resample(out positions, out velocities, out tags);
            PbfSolver next;
            try
            {
                next = new PbfSolver(new SolverLayout(domainSize, to.spacing, to.capacity, solver.neighborCapacity, solver.listMargin), limits);
            }
            catch (Exception refusal) when (refusal is ArgumentException || refusal is InvalidOperationException)
            {
                Debug.LogError($"Rill: FluidSimulation '{name}' {KeepsResolution}: {refusal.Message}", this);
                return;
            }
            colliders.ForgetForces(this);
            next.ContinueFrom(pbf);
            if (to.spacing == particleSpacing)
                ContinueConnections(pbf, next);
            pbf.Dispose();
            pbf = next;
            neighbors = null;
            particleSpacing = to.spacing;
            capacity = to.capacity;
            Upload(positions, velocities, tags);
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    ((IEmitter)emitter).OnResampled();
            StandStill();
            ClearMotions();
        }

        // Those of one tag after those of another.
        void Upload(float4[] positions, float4[] velocities, uint[] tags)
        {
            float3 low = float.MaxValue, high = float.MinValue;
            foreach (float4 position in positions)
            {
                low = math.min(low, position.xyz);
                high = math.max(high, position.xyz);
            }
            if (positions.Length == 0)
                return;
            if (tags != null)
            {
                var order = (uint[])tags.Clone();
                var velocityOrder = (uint[])tags.Clone();
                Array.Sort(order, positions);
                Array.Sort(velocityOrder, velocities);
                tags = order;
            }
            using (var at = new NativeArray<float4>(positions, Allocator.Persistent))
            using (var speeds = new NativeArray<float4>(velocities, Allocator.Persistent))
                for (int first = 0, end; first < positions.Length; first = end)
                {
                    for (end = first + 1; end < positions.Length && (tags == null || tags[end] == tags[first]); end++)
                    {
                    }
                    pbf.AddInSpacings(at.GetSubArray(first, end - first), speeds.GetSubArray(first, end - first), low, high,
                        tags != null ? tags[first] : 0);
                }
        }
    }
}
