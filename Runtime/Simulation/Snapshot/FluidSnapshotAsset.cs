using System;
using System.IO;
using UnityEngine;

namespace Rill
{
    /// <summary>A <see cref="FluidSnapshot"/> as an asset: what a <see cref="FluidSimulation"/> starts with instead of its volumes.</summary>
    [PreferBinarySerialization, Icon(PackagePaths.Icon), ManualPage("state", "fluid-snapshot")]
    public sealed class FluidSnapshotAsset : ScriptableObject
    {
        [SerializeField, HideInInspector] byte[] bytes = Array.Empty<byte>();

        [NonSerialized] FluidSnapshot snapshot;
        [NonSerialized] string problem;
        [NonSerialized] byte[] seen;

        /// <summary>Size of its content, bytes.</summary>
        public int Size => bytes.Length;

        /// <summary>The snapshot; null where there is none that can be read, see <see cref="Validate"/>.</summary>
        public FluidSnapshot Snapshot
        {
            get
            {
                Read();
                return snapshot;
            }
        }

        /// <summary>An asset in memory with a snapshot. The caller saves or destroys it.</summary>
        public static FluidSnapshotAsset Create(FluidSnapshot snapshot)
        {
            var asset = CreateInstance<FluidSnapshotAsset>();
            asset.name = "Fluid Snapshot";
            asset.Apply(snapshot);
            return asset;
        }

        /// <summary>Replaces the content; references to the asset stay.</summary>
        public void Apply(FluidSnapshot content)
        {
            if (content == null)
                throw new ArgumentNullException(nameof(content));
            bytes = content.ToBytes();
            seen = null;
        }

        /// <summary>Whether the content can be used.</summary>
        /// <param name="why">What is wrong and what to do; null if nothing is.</param>
        public bool Validate(out string why)
        {
            Read();
            why = problem;
            return why == null;
        }

        // Once for each content.
        void Read()
        {
            if (ReferenceEquals(seen, bytes))
                return;
            seen = bytes;
            snapshot = null;
            problem = null;
            try
            {
                if (bytes.Length == 0)
                    problem = $"'{name}' holds no snapshot: save one into it while the fluid runs.";
                else
                    snapshot = FluidSnapshot.FromBytes(bytes);
            }
            catch (InvalidDataException refusal)
            {
                problem = $"'{name}' cannot be used. {refusal.Message}";
            }
        }
    }
}
