using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>Snapshots as bytes: what is not a snapshot is refused in words, and nothing else comes of it.</summary>
    public class SnapshotBytesTests
    {
        static readonly SnapshotCase Small = new SnapshotCase
        {
            name = "small", depth = 0.1f, emitter = true, drain = true,
            colliders = true, dynamicViscosity = 0.5f, sleepSpeed = 0.02f, deepWater = DeepWater.On, numericalDamping = 0.5f
        };

        byte[] bytes;
        FluidSnapshot snapshot;

        [OneTimeSetUp]
        public void Capture()
        {
            using (SnapshotScene scene = new SnapshotScene(Small).Run(3))
                snapshot = scene.Take();
            bytes = snapshot.ToBytes();
        }

        [Test]
        public void Bytes_there_and_back_are_the_same()
        {
            FluidSnapshot back = FluidSnapshot.FromBytes(bytes);
            Assert.That(back.ToBytes(), Is.EqualTo(bytes));
            Assert.That((back.ParticleCount, back.StepCount, back.FluidTime, back.ParticleSpacing, back.DomainSize),
                Is.EqualTo((snapshot.ParticleCount, snapshot.StepCount, snapshot.FluidTime, snapshot.ParticleSpacing,
                snapshot.DomainSize)));
            Assert.That(back.StepCount, Is.EqualTo(3));
        }

        [Test]
        public void Every_change_of_a_byte_is_refused()
        {
            var changed = (byte[])bytes.Clone();
            var random = new System.Random(1);
            // All of the header, the table and what is at the end; some of the particles.
            for (int i = 0; i < bytes.Length; i += i < 800 || i > bytes.Length - 300 ? 1 : 997)
            {
                changed[i] ^= (byte)(1 << random.Next(8));
                Assert.That(Refusal(changed), Is.Not.Null, $"byte {i}");
                changed[i] = bytes[i];
            }
            Assert.That(Refusal(changed), Is.Null);
        }

        [Test]
        public void Every_truncation_is_refused()
        {
            for (int length = 0; length < bytes.Length; length += length < 800 ? 1 : 997)
                Assert.That(Refusal(bytes.Take(length).ToArray()), Is.Not.Null, $"{length} bytes");
            Assert.That(Refusal(bytes.Concat(new byte[] { 0 }).ToArray()), Does.Contain("no more"));
        }

        [Test]
        public void Random_bytes_are_refused()
        {
            var random = new System.Random(2);
            for (int i = 0; i < 2000; i++)
            {
                var noise = new byte[random.Next(300)];
                random.NextBytes(noise);
                if (i % 2 == 0 && noise.Length > 12)
                    Array.Copy(bytes, noise, 12);       // with the right beginning
                Assert.That(Refusal(noise), Is.Not.Null);
            }
        }

        // A checksum does not keep out who can compute one.
        [Test]
        public void Damage_below_a_right_checksum_is_refused_or_harmless()
        {
            var random = new System.Random(3);
            int refused = 0, taken = 0;
            using (SnapshotScene scene = new SnapshotScene(Small).Run(1))
            {
                for (int i = 0; i < 120; i++)
                {
                    var changed = (byte[])bytes.Clone();
                    for (int n = random.Next(1, 4); n > 0; n--)
                    {
                        // Mostly numbers of sections, lengths, counts and scalars.
                        int at = random.Next(8, i % 3 == 0 ? bytes.Length - 4 : 1200);
                        changed[at] = i % 2 == 0 ? (byte)random.Next(256) : (byte)0xFF;
                    }
                    if (Refusal(Sealed(changed)) != null)
                    {
                        refused++;
                        continue;
                    }
                    try
                    {
                        scene.Fluid.Restore(FluidSnapshot.FromBytes(Sealed(changed)));
                    }
                    catch (ArgumentException)
                    {
                        refused++;
                        continue;
                    }
                    if (taken++ < 15)
                        scene.Run(1);
                }
                scene.GoTo(3).Fluid.Restore(snapshot);
                scene.Run(2);
                Assert.That(scene.Fluid.IsRunning);
                Assert.That(scene.Read().positions.All(p => math.all(math.isfinite(p.xyz))));
            }
            TestContext.Out.WriteLine($"{refused} refused, {taken} harmless");
            Assert.That(refused, Is.GreaterThan(20));
            Assert.That(taken, Is.GreaterThan(20));
        }

        [Test]
        public void Huge_lengths_take_no_memory()
        {
            foreach (int at in new[] { 12, 24 + 8, 24 + 16, 24 + 24 + 16 })
                foreach (ulong value in new[] { 0xFFFFFFFFul, 0x7FFFFFFFul, 0x40000000ul })
                {
                    var changed = (byte[])bytes.Clone();
                    BitConverter.GetBytes((uint)value).CopyTo(changed, at);
                    long before = GC.GetAllocatedBytesForCurrentThread();
                    byte[] whole = Sealed(changed);
                    Assert.That(Refusal(whole), Is.Not.Null, $"{value} at {at}");
                    Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(5L * bytes.Length));
                }
        }

        static IEnumerable<TestCaseData> Refusals()
        {
            yield return new TestCaseData(new Func<byte[], byte[]>(b => Encoding.ASCII.GetBytes("PNG and so on")),
                "do not begin with 'RillSnap'").SetName("no snapshot");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => new byte[0]), "do not begin with 'RillSnap'").SetName("nothing");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => b.Take(b.Length - 5).ToArray()), "Read all of the file").SetName("truncated");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 8, 6)),
                "have version 6, but this package reads up to 5. Update").SetName("newer version");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, b.Length - 400, 77, false)), "checksum is another")
                .SetName("changed");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 24, 99)), "section 99 is unknown").SetName("unknown section");
            yield return new TestCaseData(new Func<byte[], byte[]>(TwoOfOneId), "two particles have the id").SetName("two of one id");
            yield return new TestCaseData(new Func<byte[], byte[]>(FarNeighbor), "a neighbor has index").SetName("a neighbor that is not there");
            yield return new TestCaseData(new Func<byte[], byte[]>(TooMuchEmitted), "more than was due").SetName("more emitted than was due");
        }

        [TestCaseSource(nameof(Refusals))]
        public void A_refusal_says_what_is_wrong(Func<byte[], byte[]> change, string expected)
            => Assert.That(Refusal(change(bytes)), Does.Contain(expected));

        // Each number of each record of its own. The checksum is right.
        [Test]
        public void A_number_that_is_not_finite_is_refused_wherever_it_stands_in_a_record()
        {
            int refused = Refuse<SolverRecord>(SnapshotSection.Solver) + Refuse<RestRecord>(SnapshotSection.Rest)
                + Refuse<CoarseRecord>(SnapshotSection.Coarse) + Refuse<ExtrapolationRecord>(SnapshotSection.Extrapolation)
                + Refuse<TimeRecord>(SnapshotSection.Time) + Refuse<EmitterRecord>(SnapshotSection.Emitters)
                + Refuse<DrainRecord>(SnapshotSection.Drains) + Refuse<ColliderRecord>(SnapshotSection.Colliders);
            Assert.That(refused, Is.GreaterThan(100));

            int Refuse<T>(SnapshotSection section) where T : struct
            {
                int count = 0;
                T[] records = FluidSnapshot.FromBytes(bytes).Contents.Values<T>(section).ToArray();
                Assert.That(records, Is.Not.Empty, section.ToString());
                foreach (object notFinite in new object[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity })
                    foreach ((string field, object changed) in WithEach(records[records.Length - 1], (float)notFinite))
                    {
                        SnapshotContents contents = FluidSnapshot.FromBytes(bytes).Contents;
                        var all = (T[])records.Clone();
                        all[all.Length - 1] = (T)changed;
                        contents.SetValues<T>(section, all);
                        Assert.That(Refusal(SnapshotFormat.Write(contents)), Is.Not.Null, $"{typeof(T).Name}{field} of {notFinite}");
                        count++;
                    }
                return count;
            }
        }

        /// <summary>A record with each of its numbers in turn not finite, or a whole one below 0 or with all bits set.</summary>
        internal static IEnumerable<(string field, object changed)> Damaged(object record)
        {
            foreach (FieldInfo field in record.GetType().GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            {
                object copy = RuntimeHelpers.GetObjectValue(record);
                object[] values = field.FieldType == typeof(float) ? new object[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity }
                    : field.FieldType == typeof(double) ? new object[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity }
                    : field.FieldType == typeof(int) ? new object[] { -2 }
                    : field.FieldType == typeof(long) ? new object[] { -1L }
                    : field.FieldType == typeof(uint) ? new object[] { uint.MaxValue } : Array.Empty<object>();
                foreach (object value in values)
                {
                    field.SetValue(copy, value);
                    yield return ("." + field.Name, copy);
                }
                if (values.Length == 0 && field.FieldType.IsValueType && !field.FieldType.IsPrimitive && !field.FieldType.IsEnum)
                    foreach ((string inner, object changed) in Damaged(field.GetValue(record)))
                    {
                        field.SetValue(copy, changed);
                        yield return ("." + field.Name + inner, copy);
                    }
            }
        }

        static IEnumerable<(string field, object changed)> WithEach(object record, float value)
        {
            foreach (FieldInfo field in record.GetType().GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            {
                object copy = RuntimeHelpers.GetObjectValue(record);
                if (field.FieldType == typeof(float) || field.FieldType == typeof(double))
                {
                    field.SetValue(copy, Convert.ChangeType(value, field.FieldType));
                    yield return ("." + field.Name, copy);
                }
                else if (field.FieldType.IsValueType && !field.FieldType.IsPrimitive && !field.FieldType.IsEnum)
                    foreach ((string inner, object changed) in WithEach(field.GetValue(record), value))
                    {
                        field.SetValue(copy, changed);
                        yield return ("." + field.Name + inner, copy);
                    }
            }
        }

        static IEnumerable<TestCaseData> WrongRecords()
        {
            yield return Wrong<SolverRecord>("spacing of 0", SnapshotSection.Solver, r => { r.spacing = 0f; return r; }, "is not a valid size");
            yield return Wrong<SolverRecord>("box without width", SnapshotSection.Solver, r => { r.domainSize.x = 0f; return r; },
                "is not a valid size");
            yield return Wrong<SolverRecord>("more moved than there are", SnapshotSection.Solver,
                r => { r.moved = r.particles + 1; return r; }, "which moved, cannot be");
            yield return Wrong<SolverRecord>("fewer at most than there are", SnapshotSection.Solver,
                r => { r.maxParticles = r.particles - 1; return r; }, "which moved, cannot be");
            yield return Wrong<SolverRecord>("more than a fluid has", SnapshotSection.Solver,
                r => { r.particles = r.maxParticles = 16777217; return r; }, "which moved, cannot be");
            yield return Wrong<SolverRecord>("substeps below 0", SnapshotSection.Solver,
                r => { r.lastSubsteps = -1; return r; }, "substeps cannot be");
            yield return Wrong<SolverRecord>("no substeps of what moved", SnapshotSection.Solver,
                r => { r.lastSubsteps = 0; return r; }, "substeps cannot be");
            yield return Wrong<SolverRecord>("1025 substeps", SnapshotSection.Solver,
                r => { r.lastSubsteps = 1025; return r; }, "substeps cannot be");
            yield return Wrong<SolverRecord>("flag", SnapshotSection.Solver, r => { r.flags = 1u << 7; return r; }, "a flag is unknown");
            yield return Wrong<SolverRecord>("flag of lifetimes", SnapshotSection.Solver,
                r => { r.hasLifetimes = 2; return r; }, "a flag is unknown");
            yield return Wrong<RestRecord>("wake", SnapshotSection.Rest, r => { r.wake = 2; return r; }, "what the water rested under");
            yield return Wrong<ExtrapolationRecord>("time step", SnapshotSection.Extrapolation,
                r => { r.lastTimeStep = -0.01f; return r; }, "last time step");
            yield return Wrong<TimeRecord>("step", SnapshotSection.Time, r => { r.stepCount = -1; return r; }, "a time is negative");
            yield return Wrong<TimeRecord>("time", SnapshotSection.Time, r => { r.fluidTime = -1.0; return r; }, "a time is negative");
            yield return Wrong<TimeRecord>("time of 2e12 s", SnapshotSection.Time, r => { r.fluidTime = 2e12; return r; }, "a time is negative");
            yield return Wrong<TimeRecord>("accumulated time", SnapshotSection.Time,
                r => { r.clock.accumulated = -1.0; return r; }, "a time is negative");
            yield return Wrong<TimeRecord>("lag", SnapshotSection.Time, r => { r.clock.lastFrameLag = -1.0; return r; }, "a time is negative");
            yield return Wrong<TimeRecord>("duration", SnapshotSection.Time, r => { r.lastDuration = -1f; return r; }, "pose of the box");
            yield return Wrong<EmitterRecord>("number", SnapshotSection.Emitters, r => { r.part.number = 32; return r; }, "number or the pose");
            yield return Wrong<EmitterRecord>("count", SnapshotSection.Emitters, r => { r.clock.due = -1; return r; }, "what an emitter let in");
            yield return Wrong<EmitterRecord>("volume", SnapshotSection.Emitters,
                r => { r.clock.volume = -1.0; return r; }, "what an emitter let in");
            yield return Wrong<DrainRecord>("number", SnapshotSection.Drains, r => { r.part.number = 32; return r; }, "number or the pose");
            yield return Wrong<DrainRecord>("budget", SnapshotSection.Drains, r => { r.budget = -1.0; return r; }, "what a drain may take");
        }

        static TestCaseData Wrong<T>(string name, SnapshotSection section, Func<T, T> change, string expected) where T : struct
            => new TestCaseData(new Func<byte[], byte[]>(b =>
            {
                SnapshotContents contents = FluidSnapshot.FromBytes(b).Contents;
                T[] records = contents.Values<T>(section).ToArray();
                records[0] = change(records[0]);
                contents.SetValues<T>(section, records);
                return SnapshotFormat.Write(contents);
            }), expected).SetName($"{typeof(T).Name} with a wrong {name}");

        [TestCaseSource(nameof(WrongRecords))]
        public void A_record_that_cannot_be_is_refused(Func<byte[], byte[]> change, string expected)
            => Assert.That(Refusal(change(bytes)), Does.Contain(expected));

        // A word more and a word less; those that depend on the box are refused by the fluid.
        [Test]
        public void A_section_of_another_length_is_refused()
        {
            var taken = new List<string>();
            using (var scene = new SnapshotScene(Small))
                foreach (SnapshotSection section in FluidSnapshot.FromBytes(bytes).Contents.Sections.Select(s => s.Key).ToArray())
                    foreach (int more in new[] { 4, -4 })
                    {
                        SnapshotContents contents = FluidSnapshot.FromBytes(bytes).Contents;
                        byte[] whole = contents.Bytes(section).ToArray();
                        if (whole.Length + more < 0)
                            continue;
                        contents.Set(section, whole.Concat(new byte[4]).Take(whole.Length + more).ToArray());
                        byte[] changed = SnapshotFormat.Write(contents);
                        if (Refusal(changed) != null)
                            continue;
                        try
                        {
                            scene.Fluid.Restore(FluidSnapshot.FromBytes(changed));
                            taken.Add($"{section} {more}");
                        }
                        catch (ArgumentException)
                        {
                        }
                    }
            Assert.That(taken, Is.Empty);
        }

        [Test]
        public void Another_box_spacing_or_capacity_is_refused_by_name_and_the_fluid_stays()
        {
            foreach ((Vector3 box, float spacing, int capacity, string expected) in new[]
            {
                (new Vector3(1f, 1f, 0.8f), 0.04f, 6000, "particle spacing of 0.05 m, but this one has 0.04 m. Set the Particle Spacing to 0.05"),
                (new Vector3(1f, 1.5f, 0.8f), 0.05f, 6000, "is of a box of 1 x 1 x 0.8 m, but this one is 1 x 1.5 x 0.8 m"),
                (new Vector3(1f, 1f, 0.8f), 0.05f, 200, $"has {snapshot.ParticleCount} particles, more than the capacity of 200. Raise " +
                    $"the Capacity to at least {snapshot.ParticleCount}"),
            })
                using (SourceScene scene = new SourceScene(box, spacing, capacity).Fill(0.05f).Step())
                {
                    ParticleState before = scene.Read();
                    ArgumentException refusal = Assert.Throws<ArgumentException>(() => scene.Fluid.Restore(snapshot));
                    Assert.That(refusal.Message, Does.Contain(expected).And.Contain("'Fluid'"));
                    TestFluid.AssertSame(scene.Read(), before);
                }
        }

        [Test]
        public void A_larger_capacity_goes_on_the_same()
        {
            using (SourceScene small = new SourceScene(Vector3.one, 0.05f, 3000).Fill(0.3f).Step(3),
                large = new SourceScene(Vector3.one, 0.05f, 5000))
            {
                FluidSnapshotRequest request = small.Fluid.RequestSnapshot();
                AsyncGPUReadback.WaitAllRequests();
                large.Fluid.Restore(request.Snapshot);
                TestFluid.AssertSame(large.Step(4).Read(), small.Step(4).Read());
            }
        }

        // A fluid without neighbors needs nothing of what the later versions brought.
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        [TestCase(4)]
        public void Bytes_of_an_older_version_go_on_the_same(int version)
        {
            SnapshotContents now = FluidSnapshot.FromBytes(bytes).Contents, old = new SnapshotContents();
            foreach (KeyValuePair<SnapshotSection, byte[]> section in now.Sections)
                if (section.Key != SnapshotSection.FlowTime || version >= 3)
                    old.Set(section.Key, section.Value);
            if (version == 1)
                old.SetValues(SnapshotSection.Counters, now.Values<uint>(SnapshotSection.Counters).Slice(0, 16));
            if (version <= 3)       // 8 words for each of 32 emitters, and none of what they press away
            {
                uint[] states = now.Values<uint>(SnapshotSection.EmitterStates).ToArray();
                old.SetValues<uint>(SnapshotSection.EmitterStates, states.Where((word, i) => i % 16 < 8).ToArray());
                now.SetValues<uint>(SnapshotSection.EmitterStates, states.Select((word, i) => i % 16 < 8 ? word : 0u).ToArray());
            }
            ParticleState expected = GoOn(new FluidSnapshot(now));
            TestFluid.AssertSame(GoOn(FluidSnapshot.FromBytes(With(SnapshotFormat.Write(old), 8, (byte)version))), expected);
        }

        static ParticleState GoOn(FluidSnapshot from)
        {
            using (var scene = new SnapshotScene(Small))
            {
                scene.GoTo(3).Fluid.Restore(from);
                return scene.Run(4).Read();
            }
        }

        [Test]
        public void Positions_that_are_no_numbers_are_culled_as_ever()
        {
            SnapshotContents contents = FluidSnapshot.FromBytes(bytes).Contents;
            float4[] positions = contents.Values<float4>(SnapshotSection.Positions).ToArray();
            positions[5].x = float.NaN;
            contents.SetValues<float4>(SnapshotSection.Positions, positions);
            using (var scene = new SnapshotScene(Small))
            {
                int before = scene.Count(ParticleCounter.NonFinite);
                scene.GoTo(3).Fluid.Restore(FluidSnapshot.FromBytes(new FluidSnapshot(contents).ToBytes()));
                scene.Run(1);
                Assert.That(scene.Count(ParticleCounter.NonFinite), Is.EqualTo(before + 1));
            }
        }

        [Test]
        public void A_fluid_that_does_not_run_says_so()
        {
            using (SourceScene scene = new SourceScene(Vector3.one, 0.05f, 100))
            {
                scene.Fluid.enabled = false;
                Assert.That(Assert.Throws<InvalidOperationException>(() => scene.Fluid.Restore(snapshot)).Message, Does.Contain("enable it before"));
                Assert.That(Assert.Throws<InvalidOperationException>(() => scene.Fluid.RequestSnapshot()).Message, Does.Contain("enable it before"));
                Assert.Throws<ArgumentNullException>(() => scene.Fluid.Restore(null));
                Assert.Throws<ArgumentNullException>(() => FluidSnapshot.FromBytes(null));
            }
        }

        // Null where they are taken.
        internal static string Refusal(byte[] given)
        {
            try
            {
                FluidSnapshot.FromBytes(given);
                return null;
            }
            catch (InvalidDataException refusal)
            {
                return refusal.Message;
            }
        }

        static byte[] With(byte[] source, int at, byte value, bool seal = true)
        {
            var changed = (byte[])source.Clone();
            changed[at] = value;
            return seal ? Sealed(changed) : changed;
        }

        static byte[] TwoOfOneId(byte[] source)
        {
            SnapshotContents contents = FluidSnapshot.FromBytes(source).Contents;
            uint[] ids = contents.Values<uint>(SnapshotSection.Ids).ToArray();
            ids[3] = ids[8];
            contents.SetValues<uint>(SnapshotSection.Ids, ids);
            return SnapshotFormat.Write(contents);
        }

        static byte[] FarNeighbor(byte[] source)
        {
            SnapshotContents contents = FluidSnapshot.FromBytes(source).Contents;
            uint[] neighbors = contents.Values<uint>(SnapshotSection.Neighbors).ToArray();
            neighbors[20] = 1u << 30;
            contents.SetValues<uint>(SnapshotSection.Neighbors, neighbors);
            return SnapshotFormat.Write(contents);
        }

        static byte[] TooMuchEmitted(byte[] source)
        {
            SnapshotContents contents = FluidSnapshot.FromBytes(source).Contents;
            EmitterRecord[] emitters = contents.Values<EmitterRecord>(SnapshotSection.Emitters).ToArray();
            emitters[0].clock.due = long.MaxValue;
            contents.SetValues<EmitterRecord>(SnapshotSection.Emitters, emitters);
            return SnapshotFormat.Write(contents);
        }

        // With the checksum that belongs to it.
        static byte[] Sealed(byte[] changed)
        {
            BitConverter.GetBytes(Crc32C.Of(changed.AsSpan(0, changed.Length - 4))).CopyTo(changed, changed.Length - 4);
            return changed;
        }
    }
}
