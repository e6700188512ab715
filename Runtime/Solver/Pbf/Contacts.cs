using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Contacts of particles that are loose balls instead of a liquid: the particle-particle collision step of Svensson 2016, as position-based
    /// contacts (Macklin et al. 2014, section 4.2). Made when first needed. See Contacts.compute.
    /// </summary>
    /// <remarks>
    /// Passes replace those of the density constraint, and need its lists. A pass carries weight from a ball to the next one only, so that a
    /// stack of more balls than passes is pressed together: see Research~/solver-study.md, "Loose balls".
    /// </remarks>
    sealed class Contacts : Stage
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Contacts");

        readonly ComputeShader shader = StageShader.LoadCompute("Contacts");
        readonly Kernel find, resolve;
        readonly StepKeywords keywords;

        public Contacts(int capacity)
        {
            find = new Kernel(shader, "FindContacts");
            resolve = new Kernel(shader, "ResolveContacts");
            keywords = new StepKeywords(shader, readsLists: true, skipsAsleep: true, weighs: true);
            Buffers.Structured<uint>("Rill.ContactCounts", capacity);
        }

        public static bool IsNeeded(in StepInput input) => input.material.contacts;

        /// <summary>Returns how many layers of balls lie on each other without a pair nearer than 0.84 d, with 4 iterations.</summary>
        /// <remarks>Measured on square lattices by <c>ContactsTests</c>. What counts is how far gravity carries a ball in a substep.</remarks>
        /// <param name="gravity">m/s².</param>
        /// <param name="spacing">m.</param>
        /// <param name="substep">s.</param>
        public static int LayersHeld(float gravity, float spacing, float substep)
        {
            float path = gravity * substep * substep / spacing;
            return path < 0.005f ? 4 : path < 0.018f ? 3 : path < 0.07f ? 2 : 1;
        }

        /// <summary>Records all passes of a substep, on its lists: Predicted ends corrected.</summary>
        public void Record(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            int passes = step.Input.settings.iterations;
            for (int i = 0; i < passes; i++)
            {
                cmd.BeginSample(Marker);
                keywords.Record(step);
                step.BindConstants(shader);
                cmd.SetComputeFloatParam(shader, Ids.PassFraction, 1f / passes);
                Dispatch(step, find, particles.Predicted, particles.Multipliers);
                Dispatch(step, resolve, particles.Multipliers, particles.Predicted);
                cmd.EndSample(Marker);
                step.Colliders?.RecordPass(step, i == passes - 1);
            }
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(Contacts stage, in StepContext step)
        {
            bool needed = IsNeeded(step.Input);
            int passes = step.Input.settings.iterations * step.Substeps;
            var description = new StageDescription("Contacts", needed, needed
                ? Invariant($"the particles are loose balls, with {step.Input.settings.iterations} passes in each of {step.Substeps} substeps")
                : "the particles are a liquid");
            if (needed && stage != null)
            {
                description.Kernel(stage.find, passes, stage.keywords.Variant(step));
                description.Kernel(stage.resolve, passes, stage.keywords.Variant(step));
                stage.Buffers.Describe(description);
            }
            return description;
        }

        void Dispatch(in StepContext step, Kernel kernel, GraphicsBuffer from, GraphicsBuffer to)
        {
            CommandBuffer cmd = step.Commands;
            Buffers.Bind(cmd, shader, kernel);
            step.BindLists(shader, kernel);
            step.Materials?.Bind(step, shader, kernel);
            step.Particles.Bind(cmd, shader, kernel);
            ParticleIds.Pass.Bind(cmd, shader, kernel, from, to);
            step.Particles.DispatchSorted(cmd, shader, kernel);
        }

        static class Ids
        {
            public static readonly int PassFraction = Shader.PropertyToID("_PassFraction");
        }
    }
}
