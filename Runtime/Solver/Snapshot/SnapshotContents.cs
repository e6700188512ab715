using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Rill
{
    /// <summary>The sections of a snapshot: bytes by number.</summary>
    sealed class SnapshotContents
    {
        readonly SortedDictionary<SnapshotSection, byte[]> sections = new SortedDictionary<SnapshotSection, byte[]>();

        /// <summary>In the order of their numbers.</summary>
        public IEnumerable<KeyValuePair<SnapshotSection, byte[]>> Sections => sections;

        public int Count => sections.Count;

        /// <summary>Floating bodies; null where it is not known whether there were any. The section of the same name has them as bytes.</summary>
        public List<SnapshotBody> Bodies { get; set; }

        public bool Has(SnapshotSection section) => sections.ContainsKey(section);

        /// <summary>Returns the bytes of a section; empty if it is missing.</summary>
        public byte[] Bytes(SnapshotSection section) => sections.TryGetValue(section, out byte[] bytes) ? bytes : Array.Empty<byte>();

        public void Set(SnapshotSection section, byte[] bytes) => sections[section] = bytes;

        /// <summary>One value that is all of a section; default where there is none of its size.</summary>
        public T Get<T>(SnapshotSection section) where T : struct
        {
            byte[] bytes = Bytes(section);
            return bytes.Length == SizeOf<T>() ? MemoryMarshal.Read<T>(bytes) : default;
        }

        public void Set<T>(SnapshotSection section, T value) where T : struct
        {
            var bytes = new byte[SizeOf<T>()];
            MemoryMarshal.Write(bytes, ref value);
            Set(section, bytes);
        }

        /// <summary>Returns the values of a section; none if it is missing.</summary>
        public ReadOnlySpan<T> Values<T>(SnapshotSection section) where T : struct => MemoryMarshal.Cast<byte, T>(Bytes(section));

        public void SetValues<T>(SnapshotSection section, ReadOnlySpan<T> values) where T : struct
            => Set(section, MemoryMarshal.AsBytes(values).ToArray());

        /// <summary>Sets a section to records; without records the section is left out.</summary>
        public void SetIfAny<T>(SnapshotSection section, List<T> records) where T : struct
        {
            if (records.Count > 0)
                SetValues<T>(section, records.ToArray());
        }

        /// <summary>Returns the fluid as at the start of its time: counts begin again with the present particles, and nothing is known of
        /// emitters, drains and colliders.</summary>
        public SnapshotContents Fluid()
        {
            var fluid = new SnapshotContents();
            foreach (KeyValuePair<SnapshotSection, byte[]> section in sections)
                fluid.Set(section.Key, section.Value);
            foreach (SnapshotSection section in new[] { SnapshotSection.Time, SnapshotSection.EmitterStates, SnapshotSection.DrainStates,
                SnapshotSection.Emitters, SnapshotSection.Drains, SnapshotSection.Colliders, SnapshotSection.Calls, SnapshotSection.Forces,
                SnapshotSection.Reactions, SnapshotSection.ReactionSums, SnapshotSection.ReactionsTaken, SnapshotSection.TakenColliders,
                SnapshotSection.Bodies })
                fluid.sections.Remove(section);

            uint[] counters = Values<uint>(SnapshotSection.Counters).ToArray();
            foreach (ParticleCounter counter in new[] { ParticleCounter.Refused, ParticleCounter.NonFinite, ParticleCounter.Emitted,
                ParticleCounter.Drained, ParticleCounter.Blocked, ParticleCounter.Waiting, ParticleCounter.Recycling, ParticleCounter.HandedIn,
                ParticleCounter.HandedOut })
                counters[(int)counter] = 0;
            counters[(int)ParticleCounter.Added] = counters[(int)ParticleCounter.Alive];
            fluid.SetValues<uint>(SnapshotSection.Counters, counters);
            return fluid;
        }

        public static int SizeOf<T>() where T : struct => Unity.Collections.LowLevel.Unsafe.UnsafeUtility.SizeOf<T>();
    }
}
