using System;
using System.Collections.Generic;
using UnityEngine.Profiling;

namespace Rill.Editor
{
    /// <summary>GPU time of each stage of the step, by recorders of Unity's profiler: all simulations of the scene together.</summary>
    /// <remarks>Running means over about 20 frames. A recorder costs a little, so Dispose when no one looks.</remarks>
    sealed class StageTimes : IDisposable
    {
        const float Gain = 0.05f;               // of the running mean, a frame
        const float MillisecondsOfNanosecond = 1e-6f;

        public readonly struct Row
        {
            public readonly string Label;
            public readonly float Milliseconds;
            /// <summary>Fraction of the longest.</summary>
            public readonly float Fraction;

            public Row(string label, float milliseconds, float fraction)
            {
                Label = label;
                Milliseconds = milliseconds;
                Fraction = fraction;
            }
        }

        /// <summary>Names of the markers, in the order of the step, and of drawing what it left.</summary>
        internal static readonly (string marker, string label)[] Stages =
        {
            ("Rill.Kill", "Kills by scripts"),
            ("Rill.Drain", "Drains"),
            ("Rill.HandOver", "Hand-over between fluids"),
            ("Rill.Rest", "Water at rest"),
            ("Rill.Fields", "Force fields"),
            ("Rill.Borders", "Borders"),
            ("Rill.CoarseColliders", "Colliders on the coarse grid"),
            ("Rill.Projection", "Deep water: projection"),
            ("Rill.Colliders", "Colliders"),
            ("Rill.ImplicitViscosity", "Dynamic viscosity"),
            ("Rill.GrainFriction", "Friction of grains"),
            ("Rill.Sort", "Sort"),
            ("Rill.List", "Neighbor list"),
            ("Rill.Lambda", "Pressure"),
            ("Rill.ApplyDeltaP", "Displacement"),
            ("Rill.Contacts", "Contacts"),
            ("Rill.DensityCorrection", "Deep water: density"),
            ("Rill.Velocity", "Velocity, smoothing"),
            ("Rill.Viscoelasticity", "Viscoelasticity"),
            ("Rill.Vorticity", "Vorticity"),
            ("Rill.Diffusion", "Diffusion of materials"),
            ("Rill.Foam", "Foam"),
            ("Rill.Smoke", "Smoke"),
            ("Rill.Emit", "Emitters"),
            ("Rill.Surface", "Surface"),
            ("Rill.Mesh", "Surface mesh"),
            ("Rill.RenderedMesh", "Surface mesh: for the renderer"),
            ("Rill.Caustics", "Caustics"),
            ("Rill.Water.SunPaths", "Water: paths of the sun"),
            ("Rill.Water.Phases", "Water: phases"),
            ("Rill.Water.Faces", "Water: nearest faces"),
            ("Rill.Water.Rays", "Water: rays"),
            ("Rill.Water.Tiles", "Water: tiles"),
            ("Rill.Water.Spray", "Water: spray and foam"),
            ("Rill.Wetness", "Wet surfaces"),
            ("Rill.Queries", "Probes and detectors"),
            ("Rill.QueryBatch", "Batches of points and rays"),
            ("Rill.Recording", "Recording and playback"),
            ("Rill.Statistics", "Statistics"),
        };

        readonly Recorder[] recorders = new Recorder[Stages.Length];
        readonly float[] readings = new float[Stages.Length], means = new float[Stages.Length];
        readonly List<Row> rows = new List<Row>();
        int lastFrame = -1, samples;

        /// <summary>Stages that take time, in the order of the step; none while nothing is known.</summary>
        public List<Row> Rows => rows;

        /// <summary>ms a frame.</summary>
        public float Total { get; private set; }

        /// <summary>Takes a frame's times, once.</summary>
        public void Update(int frame)
        {
            if (frame == lastFrame)
                return;
            lastFrame = frame;
            FindRecorders();
            for (int i = 0; i < recorders.Length; i++)
                readings[i] = recorders[i].gpuSampleBlockCount > 0 ? recorders[i].gpuElapsedNanoseconds * MillisecondsOfNanosecond : 0f;
            Add(readings);
        }

        /// <param name="milliseconds">Times of a frame, ms, by stage; all 0 if the frame took no step or is not known.</param>
        internal void Add(float[] milliseconds)
        {
            float sum = 0f;
            foreach (float time in milliseconds)
                sum += time;
            if (sum <= 0f)
                return;
            samples++;
            float gain = Math.Max(Gain, 1f / samples);      // a plain mean at first
            for (int i = 0; i < means.Length; i++)
                means[i] += gain * (milliseconds[i] - means[i]);
            ListRows();
        }

        public static string WhyNone(bool supported)
        {
            return supported ? "No GPU time has come back yet." : "This device tells no GPU time of parts of a frame.";
        }

        public void Dispose()
        {
            foreach (Recorder recorder in recorders)
                if (recorder != null)
                    recorder.enabled = false;
        }

        // A marker is there from when its stage is first needed.
        void FindRecorders()
        {
            for (int i = 0; i < recorders.Length; i++)
            {
                if (recorders[i] != null && recorders[i].isValid)
                    continue;
                recorders[i] = Recorder.Get(Stages[i].marker);
                recorders[i].enabled = true;
            }
        }

        void ListRows()
        {
            rows.Clear();
            Total = 0f;
            float longest = 0f;
            foreach (float mean in means)
            {
                Total += mean;
                longest = Math.Max(longest, mean);
            }
            for (int i = 0; i < means.Length; i++)
                if (means[i] > 0f)
                    rows.Add(new Row(Stages[i].label, means[i], means[i] / longest));
        }
    }
}
