using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Access of others between steps: passes and edits of scripts, answers to probes, frames of a recording.
    partial class PbfSolver
    {
        GraphicsBuffer noTags;

        /// <summary>Differs once the buffers of the particles have changed roles.</summary>
        public int StateVersion { get; private set; }

        /// <summary>Differs after a <see cref="Clear"/>: the particles are others.</summary>
        public int Generation { get; private set; }

        /// <summary>uint [cells + 1], see <see cref="RecordOrder"/>.</summary>
        public GraphicsBuffer CellStarts => neighborSearch.CellStartsAtRest;

        /// <summary>uint [capacity], indices of particles by cell after <see cref="RecordOrder"/>.</summary>
        public GraphicsBuffer ParticleOrder => particles.SortedIds;

        /// <summary>The ParticleTags, or a buffer of one word that stands for them.</summary>
        public GraphicsBuffer TagsToBind
        {
            get
            {
                if (ParticleTags != null)
                    return ParticleTags.Current;
                if (noTags == null)
                {
                    noTags = GpuBuffer.Structured<uint>("Rill.NoTags", 1);
                    BufferClear.Now(noTags);
                }
                return noTags;
            }
        }

        /// <summary>Records a kernel in groups of <see cref="ParticleBuffers.Group"/> threads for the particles alive.</summary>
        public void DispatchAlive(CommandBuffer cmd, ComputeShader shader, int kernel) => particles.DispatchAlive(cmd, shader, kernel);

        /// <summary>Records the listing of the particles by cell, at their current positions; it holds until a step or until some are
        /// added.</summary>
        public void RecordOrder(CommandBuffer cmd)
        {
            // After a step its constants are there; of these, the listing reads the layout alone.
            if (lastSubsteps == 0)
                UploadConstants(cmd, new StepInput { timeStep = 1f, settings = SolverSettings.Default, material = FluidMaterial.Water });
            NeedAccess().RecordOrder(BetweenSteps(cmd));
        }

        /// <summary>Before the passes of a step, which then find the phases that its input asks for.</summary>
        public void PreparePhases(in StepInput input)
        {
            if (input.HasPhases)
                NeedTags();
        }

        /// <summary>Records a copy of the particles in world space, see <see cref="ParticleAccess"/>.</summary>
        public void RecordCopy(CommandBuffer cmd, Matrix4x4 domainToWorld, in ParticleCopyLayout layout, GraphicsBuffer copy)
            => NeedAccess().RecordCopy(cmd, particles, TagsToBind, ParticleTags != null, domainToWorld, layout, copy);

        void RecordKills(in StepContext step)
        {
            if (step.Input.removesKilled)
                NeedAccess().RecordKills(step);
        }

        // Marks what was taken of the particles before as outdated.
        void InvalidateParticles(bool areOthers)
        {
            StateVersion++;
            Generation += areOthers ? 1 : 0;
        }

        ParticleAccess NeedAccess() => Access ?? Keep(Features.ParticleAccess, new ParticleAccess());

        ScriptRefusals refusals;
        uint markedAfter;       // 1 more than the steps after which particles were marked as removed; 0 for never

        /// <summary>Whether particles are marked as removed that the next sort leaves out.</summary>
        public bool HasMarked => markedAfter == stepIndex + 1;

        /// <summary>Removes all particles at once, with their foam and those kept outside. Steps, counters, ids and what waits in emitters go
        /// on.</summary>
        public void RemoveAll()
        {
            hasLists = hasNew = neighborSearch.IsSorted = false;
            markedAfter = 0;
            RemoveOutside();
            InvalidateSurface();
            InvalidateParticles(true);
            ReleaseWhatEnds(ParticleChange.Removed);
            hasLifetimes = false;
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
            NeedEdits().RemoveInside(BetweenSteps(Edits.Commands), shape);
            markedAfter = stepIndex + 1;
        }

        /// <summary>Moves all particles in the domain's frame, at once, and removes those that then lie outside. Foam, and what the coarse
        /// grid knows, begin again.</summary>
        /// <param name="by">d.</param>
        public void Shift(float3 by)
        {
            PrepareConstants();
            NeedEdits().Shift(BetweenSteps(Edits.Commands), by);
            neighborSearch.IsSorted = false;
            markedAfter = stepIndex + 1;
            InvalidateSurface();
            InvalidateParticles(false);
            ReleaseWhatEnds(ParticleChange.Shifted);
            if (!math.all(minAdded <= maxAdded))
                return;
            minAdded = math.clamp(minAdded + by, 0f, Layout.DomainSize);
            maxAdded = math.clamp(maxAdded + by, 0f, Layout.DomainSize);
        }

        /// <summary>Adds those of some particles that have room between the others and beside the colliders, at once.</summary>
        /// <param name="positions">xyz, d, in the domain's frame.</param>
        /// <param name="velocity">d/s, of all.</param>
        /// <param name="low">Lowest coordinates of the positions, d, within the domain.</param>
        /// <param name="high">Highest coordinates of the positions, d, within the domain.</param>
        /// <param name="tag">Tag of all of them, see ParticleTags.hlsl; what it asks for is there.</param>
        public void AddIntoFreeSpace(NativeArray<float4> positions, float3 velocity, float3 low, float3 high, uint tag)
        {
            PrepareConstants();
            NeedEdits().AddIntoFreeSpace(BetweenSteps(Edits.Commands), positions, velocity, tag, ParticleTags);
            if (stepIndex == 0)
                LeaveOutCovered();
            MarkAdded(positions.Length, low, high);
        }

        /// <summary>The tag of particles that come now. Makes what their phase and lifetime need.</summary>
        /// <param name="lifetimeSteps">0 for ever.</param>
        public uint TagFor(int phase, int lifetimeSteps)
        {
            if (phase == 0 && lifetimeSteps == 0)
                return 0;
            NeedTags();
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
        void MarkAdded(int count, float3 low, float3 high)
        {
            maxParticles += count;
            minAdded = math.min(minAdded, low);
            maxAdded = math.max(maxAdded, high);
            Wake();
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

        ParticleEdits NeedEdits() => Edits ?? Keep(Features.ParticleEdits, new ParticleEdits());

        QueryShader queryShader;
        QueryInput queried;     // of the newest frame

        QueryShader QueryShader => queryShader ??= new QueryShader();

        /// <summary>Makes what answers, where there is none yet.</summary>
        public Queries MakeQueries() => Queries ?? Keep(Features.Queries, new Queries(QueryShader, ReadbackErrors));

        /// <summary>Records the answers of the current state, after a step or between steps.</summary>
        /// <param name="slot">A <see cref="Queries.FreeSlot"/>.</param>
        public void RecordQueries(CommandBuffer cmd, QueryInput input, int slot)
        {
            queried = input;
            Queries.Record(PrepareAnswers(cmd), ParticleTags, input, slot);
        }

        /// <summary>Records the answers to batches that have asked: one kind of dispatch of all after the other, since those of a kind need not
        /// wait for each other.</summary>
        public void RecordBatches(CommandBuffer cmd, List<QueryBatch> batches)
        {
            StepContext step = PrepareAnswers(cmd);
            cmd.BeginSample(QueryBatch.Marker);
            foreach (QueryBatch batch in batches)
                batch.RecordUpload(cmd);
            foreach (QueryBatch batch in batches)
                batch.RecordSearch(step, QueryShader, ParticleTags);
            foreach (QueryBatch batch in batches)
                batch.RecordPoints(step, QueryShader, ParticleTags);
            foreach (QueryBatch batch in batches)
                batch.RecordRays(step, QueryShader, ParticleTags);
            cmd.EndSample(QueryBatch.Marker);
        }

        StepContext PrepareAnswers(CommandBuffer cmd)
        {
            PrepareConstants();
            QueryShader.HasRemoved = HasMarked;
            return BetweenSteps(cmd);
        }

        /// <summary>Describes the cost of a batch.</summary>
        public void DescribeBatch(QueryBatch batch, StageDescription description) => batch.Describe(description, QueryShader, ParticleTags);

        /// <summary>Gives back what answering needs, where nothing asks any more.</summary>
        public void ReleaseQueries()
        {
            Release(Features.Queries);
            queried = null;
        }

        /// <summary>Records the packing of the particles as the commands so far leave them.</summary>
        /// <param name="frame">uint, see <see cref="FramePacking.RecordPack"/>.</param>
        public void RecordFrame(CommandBuffer cmd, in FrameLayout layout, GraphicsBuffer frame)
            => NeedPacking().RecordPack(cmd, particles, ParticleTags?.Current, Layout.DomainSize, layout, frame);

        /// <summary>
        /// Uploads a frame and records it instead of the present state, with its cells and neighbor lists, so that all that looks at the
        /// particles finds them as after a step: it is one in which nothing acts, from before the frame along the velocities.
        /// </summary>
        /// <param name="still">An input without anything that acts, with one substep and no iteration.</param>
        /// <param name="follows">Whether it goes on from the state that is there: with the same ids, and not after a jump.</param>
        public void ShowFrame(CommandBuffer cmd, in StepInput still, in FrameLayout layout, RecordedFrame frame, bool follows)
        {
            if (!follows)
                InvalidateSurface();
            if (layout.Has(RecordingFields.Phases))
                NeedTags();
            else
                ReleaseTags();
            hasLifetimes = false;
            markedAfter = 0;
            stepIndex = (uint)math.max(frame.step - 1, 0);      // of which Step makes the frame's
            maxParticles = frame.particles;
            minAdded = 0f;      // where they are is not known here
            maxAdded = Layout.DomainSize;
            NeedPacking().RecordUnpack(cmd, particles, ParticleTags?.Current, Layout.DomainSize, layout, frame, still.timeStep);
            Step(cmd, still);
        }

        /// <summary>Gives back what frames need, where none are recorded or shown any more.</summary>
        public void ReleasePacking() => Release(Features.Recording);

        FramePacking NeedPacking() => Packing ?? Keep(Features.Recording, new FramePacking());
    }
}
