using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Changes the spacing or capacity of a fluid that runs: a new solver gets the water of the old one. The fluid's time stands still
    /// until the water has come back from the GPU.</summary>
    sealed class ResolutionChange
    {
        sealed class PendingChange
        {
            public float spacing;
            public int capacity;
            public SnapshotContents water;
            public string problem;
            public bool isDone, isStale;
        }

        readonly FluidSimulation fluid;
        PendingChange pending;

        public ResolutionChange(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Whether the water is on its way to another spacing or capacity.</summary>
        public bool IsPending => pending != null;

        /// <summary>Spacing that the fluid has or is about to have, m.</summary>
        public float Spacing => pending?.spacing ?? fluid.ParticleSpacing;

        /// <summary>Capacity that the fluid has or is about to have.</summary>
        public int Capacity => pending?.capacity ?? fluid.Capacity;

        /// <summary>Gives the fluid another spacing and capacity, with its water where that is possible.</summary>
        /// <param name="canKeep">Whether the fluid's layout is still that of its settings.</param>
        public void Change(float spacing, int capacity, bool canKeep)
        {
            bool keeps = fluid.Solver != null && !fluid.IsInEditMode && !fluid.IsPlayedBack && canKeep && IsPossible(spacing, capacity);
            if (!keeps)
            {
                fluid.ConfigureIfOther(fluid.DomainSize, spacing, capacity);
                return;
            }
            if (spacing == Spacing && capacity == Capacity)
                return;
            pending = new PendingChange { spacing = spacing, capacity = capacity };
            RequestWater(pending);
        }

        /// <summary>Marks the water that is being read back as outdated, since scripts have changed the fluid.</summary>
        public void MarkChanged()
        {
            if (pending != null)
                pending.isStale = true;
        }

        /// <summary>Drops a change that is pending.</summary>
        public void Cancel() => pending = null;

        /// <summary>Ends a change before the steps of a frame, once its water has come.</summary>
        public void Finish()
        {
            if (pending == null || !pending.isDone)
                return;
            if (pending.isStale)
            {
                RequestWater(pending);
                return;
            }
            PendingChange done = pending;
            pending = null;
            if (done.problem != null)
            {
                Debug.LogError($"Rill: FluidSimulation '{fluid.name}' {KeepsResolution}: {done.problem}", fluid);
                return;
            }
            fluid.GetPose(out _, out Quaternion rotation);
            var resampler = new WaterResampler(done.water.Values<float4>(SnapshotSection.Positions),
                done.water.Values<float4>(SnapshotSection.Velocities), done.water.Values<uint>(SnapshotSection.Tags),
                fluid.ParticleSpacing / done.spacing, (float3)fluid.DomainSize / done.spacing,
                math.normalizesafe((float3)(Quaternion.Inverse(rotation) * fluid.Gravity)), fluid.Inputs.Colliders.Set);
            if (resampler.Wanted > done.capacity)
            {
                Debug.LogError(Invariant($"Rill: FluidSimulation '{fluid.name}' {KeepsResolution}: its water is {resampler.Wanted:N0} particles ") +
                    Invariant($"at a spacing of {done.spacing} m, more than the capacity of {done.capacity:N0}. Raise the capacity first, or ") +
                    "remove water.", fluid);
                return;
            }
            Switch(done, resampler);
        }

        bool IsPossible(float spacing, int capacity)
        {
            try
            {
                return fluid.Support.Begin(fluid.SolverOwner.MakeLayout(spacing, capacity)) == null;
            }
            catch (ArgumentException)
            {
                return false;       // which is logged as the fluid begins again
            }
        }

        void RequestWater(PendingChange of)
        {
            of.isDone = of.isStale = false;
            fluid.Solver.CaptureParticles().Request((water, problem) =>
            {
                of.water = water;
                of.problem = problem;
                of.isDone = true;
            });
        }

        string KeepsResolution
            => Invariant($"keeps its particle spacing of {fluid.ParticleSpacing} m and its capacity of {fluid.Capacity:N0}");

        void Switch(PendingChange to, WaterResampler resampler)
        {
            bool keepsSpacing = to.spacing == fluid.ParticleSpacing;
            float4[] positions, velocities;
            uint[] tags;
            if (keepsSpacing)
                resampler.Copy(out positions, out velocities, out tags);
            else
                resampler.Resample(out positions, out velocities, out tags);
            PbfSolver next;
            try
            {
                next = new PbfSolver(fluid.SolverOwner.MakeLayout(to.spacing, to.capacity), fluid.Support.Limits);
            }
            catch (Exception refusal) when (refusal is ArgumentException || refusal is InvalidOperationException)
            {
                Debug.LogError($"Rill: FluidSimulation '{fluid.name}' {KeepsResolution}: {refusal.Message}", fluid);
                return;
            }
            fluid.Inputs.Colliders.DropForces();
            next.ContinueFrom(fluid.Solver);
            if (keepsSpacing)
                fluid.Inputs.Connections.Continue(fluid.Solver, next);
            fluid.SolverOwner.Replace(next);
            fluid.Inputs.Connections.Release();
            fluid.SetResolution(to.spacing, to.capacity);
            Upload(positions, velocities, tags);
            fluid.Inputs.Parts.ContinueResampled();
            fluid.ResetMotion();
        }

        // Particles of one tag after those of another.
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
                    fluid.Solver.AddInSpacings(at.GetSubArray(first, end - first), speeds.GetSubArray(first, end - first), low, high,
                        tags != null ? tags[first] : 0);
                }
        }
    }
}
