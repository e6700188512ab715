using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // The particles for a project's own passes, draws and readbacks.
    public sealed partial class FluidSimulation
    {
        Delegates<Action<CommandBuffer, FluidParticles>> passes;
        [NonSerialized] bool isRecordingPasses;

        /// <summary>
        /// Called at the start of each fixed step, which may be none or several times a frame, to record compute passes that read the
        /// particles or change their velocities and phases or remove some; what they change acts in that step. Record into the command
        /// buffer and keep neither argument.
        /// </summary>
        /// <remarks>
        /// Passes run in the order in which they were added, before drains, force fields and the fluid's own passes. One that throws is
        /// logged once, and the others go on. Water that sleeps wakes where particles were removed or got a velocity above the sleep speed.
        /// While there is any, each step also looks for particles to remove.
        /// </remarks>
        public event Action<CommandBuffer, FluidParticles> BeforeStep { add => passes.Add(value); remove => passes.Remove(value); }

        /// <summary>
        /// Whether particles have phases even where no emitter gives any, so that a pass can set them. From the passes of the next step on; once
        /// there they stay until a restart. 8 bytes for each particle of the capacity, and one dispatch a substep.
        /// </summary>
        [field: NonSerialized] public bool TrackPhases { get; set; }

        /// <summary>
        /// The particles as the last step left them; false while the fluid is not running. In LateUpdate of an order above
        /// <see cref="ExecutionOrder"/> they are those of the current frame.
        /// </summary>
        public bool TryGetParticles(out FluidParticles particles)
        {
            particles = pbf != null ? new FluidParticles(this) : default;
            return pbf != null;
        }

        /// <summary>Asks for a copy of the particles on the CPU, as the last step left them. It never waits: the copy comes two or three
        /// frames later.</summary>
        /// <param name="readback">Gets the copy. Use it again for every request.</param>
        /// <param name="fields">What to bring of each particle: the fewer, the less memory and traffic.</param>
        /// <returns>Whether the request is pending. False while the one before is, in a player without a graphics device, and where the
        /// stage ParticleAccess is not in the build, which is logged.</returns>
        /// <exception cref="ArgumentNullException">No readback.</exception>
        /// <exception cref="ArgumentOutOfRangeException">No field, or a copy of all fields is more than the device can bind.</exception>
        /// <exception cref="ObjectDisposedException">The readback was disposed of.</exception>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device.</exception>
        public bool RequestParticles(ParticleReadback readback, ParticleFields fields = ParticleFields.All)
        {
            if (readback == null)
                throw new ArgumentNullException(nameof(readback));
            if ((fields & ParticleFields.All) == 0)
                throw Limit.OutOfRange(nameof(fields), fields, "A request brings at least one field.");
            bool isPending = readback.IsPending;
            if (pbf == null && HasNoGraphics)
                return false;
            if (pbf == null)
                throw new InvalidOperationException($"FluidSimulation '{name}' is not running: enable it before asking for its particles.");
            if (isPending)
                return false;
            if (!Gate.IsLoaded(Features.ParticleAccess))
            {
                readback.Fail();
                return false;
            }
            readback.Request(this, fields & ParticleFields.All);
            return true;
        }

        /// <summary>Records the passes of scripts before a step.</summary>
        /// <returns>Whether there is still a step to take.</returns>
        bool RecordPasses()
        {
            input.removesKilled = false;
            if (passes.IsEmpty)
                return true;
            PbfSolver before = pbf;
            pbf.PreparePhases(input);
            isRecordingPasses = true;
            foreach (Action<CommandBuffer, FluidParticles> pass in passes.All)
            {
                try
                {
                    pass(commands, new FluidParticles(this));
                }
                catch (Exception problem)       // of a script, as in any of its messages
                {
                    Thrown.Log(problem, pass, this);
                }
                if (pbf != before)      // disabled by the pass
                    break;
            }
            isRecordingPasses = false;
            if (pbf != before)
                return false;
            input.removesKilled = Gate.IsLoaded(Features.ParticleAccess);
            return true;
        }

        void ThrowInPass()
        {
            if (isRecordingPasses)
                throw new InvalidOperationException($"FluidSimulation '{name}' cannot start again in a pass of BeforeStep, whose step " +
                    $"is being recorded: call Restart or Restore in Update.");
        }
    }
}
