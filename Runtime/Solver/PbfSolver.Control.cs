using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // What scripts do to the particles between steps.
    partial class PbfSolver
    {
        ParticleEdits edits;
        ScriptRefusals refusals;
        uint markedAfter;       // 1 more than the steps after which particles were marked as removed; 0 for never

        /// <summary>Whether particles are marked as removed that the next sort leaves out.</summary>
        public bool HasMarked => markedAfter == stepIndex + 1;

        ParticleEdits Edits => edits ??= new ParticleEdits();

        /// <summary>Removes all particles at once, with their foam and those kept outside. Steps, counters, ids and what waits in emitters go
        /// on.</summary>
        public void RemoveAll()
        {
            hasLists = hasNew = neighborSearch.IsSorted = false;
            markedAfter = 0;
            RemoveKept();
            InvalidateSurface();
            InvalidateParticles(true);
            foam?.Clear();
            ReleaseCoarse();
            ReleaseViscosity();
            ReleaseViscoelasticity();
            ReleaseExtrapolation();
            ReleaseTags();
            restingRegions?.Wake();
            minAdded = float.MaxValue;
            maxAdded = float.MinValue;
            using (var cmd = new CommandBuffer { name = "Rill.RemoveAll" })
            {
                particleUpload.RemoveAll(cmd, particles);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        /// <summary>Removes the particles inside a shape at once. They count as alive until the next step.</summary>
        /// <param name="shape">In the domain's frame, d.</param>
        public void RemoveInside(in RoundedBox shape)
        {
            PrepareConstants();
            Edits.RemoveInside(BetweenSteps(Edits.Commands), shape);
            markedAfter = stepIndex + 1;
        }

        /// <summary>Moves all particles in the domain's frame, at once, and removes those that then lie outside. Foam, and what the coarse
        /// grid knows, begin again.</summary>
        /// <param name="by">d.</param>
        public void Shift(float3 by)
        {
            PrepareConstants();
            Edits.Shift(BetweenSteps(Edits.Commands), by);
            neighborSearch.IsSorted = false;
            markedAfter = stepIndex + 1;
            InvalidateSurface();
            InvalidateParticles(false);
            foam?.Clear();
            ReleaseCoarse();
            restingRegions?.Wake();
            if (!math.all(minAdded <= maxAdded))
                return;
            minAdded = math.clamp(minAdded + by, 0f, Layout.DomainSize);
            maxAdded = math.clamp(maxAdded + by, 0f, Layout.DomainSize);
        }

        /// <summary>Adds those of some particles that have room between the others and beside the colliders, at once.</summary>
        /// <param name="positions">xyz, d, in the domain's frame.</param>
        /// <param name="velocity">d/s, of all.</param>
        /// <param name="low">Lowest coordinates of the positions, d, within the domain.</param>
        /// <param name="high">And the highest.</param>
        /// <param name="tag">Of all of them, see ParticleTags.hlsl; what it asks for is there.</param>
        public void AddWhereFree(NativeArray<float4> positions, float3 velocity, float3 low, float3 high, uint tag)
        {
            PrepareConstants();
            Edits.AddWhereFree(BetweenSteps(Edits.Commands), positions, velocity, tag, tags);
            if (stepIndex == 0)
                LeaveOutCovered();
            NoteAdded(positions.Length, low, high);
        }

        /// <summary>The tag of particles that come now. Makes what their phase and lifetime need.</summary>
        /// <param name="lifetimeSteps">0 for ever.</param>
        public uint TagFor(int phase, int lifetimeSteps)
        {
            if (phase == 0 && lifetimeSteps == 0)
                return 0;
            tags ??= new ParticleTags(Layout.Capacity);
            hasLifetimes |= lifetimeSteps > 0;
            return new EmitterStep { phase = phase, lifetimeSteps = lifetimeSteps }.TagIn(stepIndex);
        }

        /// <summary>Particles added by scripts that the capacity did not hold, as far as it has come back.</summary>
        public int RefusedOfScripts => refusals?.Count ?? 0;

        /// <summary>Before a script adds particles.</summary>
        /// <param name="arrived">Called when <see cref="RefusedOfScripts"/> may have changed.</param>
        public void BeginBatch(Action arrived)
        {
            refusals ??= new ScriptRefusals(arrived, ReadbackErrors);
            particleUpload.CountRefused(particles, refusals.Buffer, false);
        }

        /// <summary>After it did.</summary>
        public void EndBatch()
        {
            particleUpload.CountRefused(particles, refusals.Buffer, true);
            refusals.Request();
        }

        /// <summary>Asks again for what the device did not give and no step asks for.</summary>
        public void RequestLost() => refusals?.RequestLost();

        // After particles came between steps.
        void NoteAdded(int count, float3 low, float3 high)
        {
            maxParticles += count;
            minAdded = math.min(minAdded, low);
            maxAdded = math.max(maxAdded, high);
            restingRegions?.Wake();
            SurfaceIsCurrent = false;
            hasNew = true;
        }

        // Between steps the constants are those of the last; before the first, of the layout alone.
        void PrepareConstants()
        {
            if (lastSubsteps > 0 && !isRestored)
                return;
            using (var cmd = new CommandBuffer { name = "Rill.Constants" })
            {
                UploadConstants(cmd, new StepInput { timeStep = 1f, settings = SolverSettings.Default, material = FluidMaterial.Water });
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        void ReleaseEdits()
        {
            edits?.Dispose();
            edits = null;
            refusals?.Dispose();
            refusals = null;
        }
    }
}
