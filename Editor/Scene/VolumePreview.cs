using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>
    /// The particles that volumes would fill, in the scene view outside play mode: one mesh a volume, made again where something that
    /// it depends on has changed. A repaint compares and draws, and does nothing else.
    /// </summary>
    static class VolumePreview
    {
        /// <summary>Particles of a volume that are drawn at most. Of more, each n-th is.</summary>
        public const int MaxDrawn = 20000;

        /// <summary>Particles that are looked for at most, since a drag looks for them again and again.</summary>
        public const int MaxSought = 1000000;

        static readonly Dictionary<FluidVolume, Entry> entries = new Dictionary<FluidVolume, Entry>();

        /// <summary>Meshes that were made so far.</summary>
        internal static int MadeCount { get; private set; }

        /// <summary>Draws the particles of a volume that acts on an enabled fluid, as a gizmo.</summary>
        public static void Draw(FluidVolume volume)
        {
            FluidSimulation fluid = FluidOf(volume);
            if (fluid == null)
                return;
            Mesh mesh = MeshOf(volume, fluid);
            if (mesh == null)
                return;
            Gizmos.color = ColorOf(fluid);
            Gizmos.matrix = fluid.DomainToWorld;
            Gizmos.DrawMesh(mesh);
        }

        /// <summary>Tells which particles are not shown, and why; null if all are.</summary>
        public static string HiddenNote(FluidVolume volume)
        {
            FluidSimulation fluid = FluidOf(volume);
            if (fluid == null)
                return null;
            double particles = FillEstimate.Particles(volume, fluid.ParticleSpacing);
            if (particles > MaxSought)
                return Invariant($"The scene view does not show its particles: more than {MaxSought:N0}.");
            int step = StepOf((int)particles);
            return step == 1 ? null
                : Invariant($"The scene view shows every {step}{Ordinal(step)} of its particles, since it draws at most {MaxDrawn:N0}.");
        }

        /// <summary>The fluid whose start a volume fills; null where it fills none, or something else is seen of it.</summary>
        internal static FluidSimulation FluidOf(FluidVolume volume)
        {
            if (Application.isPlaying || !volume.isActiveAndEnabled)
                return null;
            var fluid = volume.GetComponentInParent<FluidSimulation>();
            bool fills = fluid != null && fluid.isActiveAndEnabled && fluid.StartState == null && !SceneSimulation.Runs(fluid);
            return fills && fluid.ParticleSpacing > 0f ? fluid : null;
        }

        /// <summary>Mesh to draw, in the domain's frame, spacings; null if there is nothing to draw.</summary>
        internal static Mesh MeshOf(FluidVolume volume, FluidSimulation fluid)
        {
            var key = Key.Of(volume, fluid);
            if (entries.TryGetValue(volume, out Entry entry) && entry.key.Equals(key))
                return entry.mesh;
            ForgetGone();
            if (entry == null)
                entries.Add(volume, entry = new Entry());
            entry.key = key;
            EngineObject.Destroy(ref entry.mesh);
            entry.mesh = Make(volume, fluid);
            return entry.mesh;
        }

        /// <summary>Gives all meshes back.</summary>
        internal static void Clear()
        {
            foreach (Entry entry in entries.Values)
                EngineObject.Destroy(ref entry.mesh);
            entries.Clear();
        }

        [InitializeOnLoadMethod]
        static void Watch()
        {
            AssemblyReloadEvents.beforeAssemblyReload += Clear;
            EditorApplication.playModeStateChanged += change => Clear();
            EditorApplication.hierarchyChanged += ForgetGone;
        }

        static void ForgetGone()
        {
            List<FluidVolume> gone = null;
            foreach (FluidVolume volume in entries.Keys)
                if (volume == null)
                    (gone ??= new List<FluidVolume>()).Add(volume);
            if (gone == null)
                return;
            foreach (FluidVolume volume in gone)
            {
                EngineObject.Destroy(ref entries[volume].mesh);
                entries.Remove(volume);
            }
        }

        static Mesh Make(FluidVolume volume, FluidSimulation fluid)
        {
            if (FillEstimate.Particles(volume, fluid.ParticleSpacing) > MaxSought)
                return null;
            NativeArray<float4> positions = default;
            try
            {
                positions = fluid.Editing.Filling.PositionsOf(volume, out int inside, out _, out _);
                if (inside == 0)
                    return null;
                MadeCount++;
                return ParticleMesh.Make(positions.AsReadOnlySpan().Slice(0, inside), StepOf(inside));
            }
            catch (ArgumentException)       // the inspector says what is wrong
            {
                return null;
            }
            finally
            {
                if (positions.IsCreated)
                    positions.Dispose();
            }
        }

        static int StepOf(int particles) => Math.Max((particles + MaxDrawn - 1) / MaxDrawn, 1);

        static string Ordinal(int number)
        {
            if (number % 100 / 10 == 1)
                return "th";
            return (number % 10) switch { 1 => "st", 2 => "nd", 3 => "rd", _ => "th" };
        }

        // Color of the particles where they are drawn, otherwise of the light that comes through the water.
        static Color ColorOf(FluidSimulation fluid)
        {
            if (fluid.TryGetComponent(out ParticleRenderer particles) && particles.enabled)
                return particles.SlowColor;
            return fluid.TryGetComponent(out FluidSurface surface) && surface.enabled ? surface.Look.colorAtDepth : GizmoColors.Volume;
        }

        sealed class Entry
        {
            public Key key;
            public Mesh mesh;
        }

        // Inputs that the particles depend on.
        struct Key : IEquatable<Key>
        {
            const float Rounding = 1e-3f;       // of a position, spacings

            VolumeShape shape;
            Vector3 size, scale, position, box;
            Quaternion rotation;
            float radius, spacing;
            int seed;
            SignedDistanceField field;

            public static Key Of(FluidVolume volume, FluidSimulation fluid)
            {
                Transform at = volume.transform, frame = fluid.transform;
                Quaternion toFrame = Quaternion.Inverse(frame.rotation);
                return new Key
                {
                    shape = volume.Shape, size = volume.Size, radius = volume.Radius, field = volume.Field, scale = at.lossyScale,
                    position = toFrame * (at.position - frame.position), rotation = toFrame * at.rotation,
                    box = fluid.DomainSize, spacing = fluid.ParticleSpacing, seed = fluid.Seed,
                };
            }

            public bool Equals(Key other) => shape == other.shape && size.Equals(other.size) && radius.Equals(other.radius)
                && ReferenceEquals(field, other.field) && scale.Equals(other.scale) && IsAt(other) && box.Equals(other.box)
                && spacing.Equals(other.spacing) && seed == other.seed;

            // A box that is moved with its volumes leaves them where they are in it, but for a rounding.
            bool IsAt(in Key other) => Vector3.Distance(position, other.position) <= Rounding * spacing
                && math.cmax(math.abs(((quaternion)rotation).value - ((quaternion)other.rotation).value)) <= 0.01f * Rounding;
        }
    }
}
