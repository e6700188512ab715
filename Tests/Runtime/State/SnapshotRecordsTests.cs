using System;
using System.Collections.Generic;
using System.IO;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Each number of each record of a snapshot's bytes is damaged, under a right checksum, and refused.</summary>
    public class SnapshotRecordsTests : CallsFixture
    {
        // Values that no whole number of a record can have; all others may have any bits.
        static readonly HashSet<string> AnyBits = new HashSet<string> { ".goneEmitters", ".goneDrains", ".settings", ".material", ".nextId" };

        [Test, Category("LongRun")]
        public void A_number_that_cannot_be_is_refused_in_each_record([Values] bool sleeps)
        {
            Make(sleeps);
            Run(sleeps ? Asleep : Before);
            Do(Call.TeleportFluid);
            byte[] bytes = Take().ToBytes();
            int refused = Refuse<TimeRecord>(SnapshotSection.Time) + Refuse<CallsRecord>(SnapshotSection.Calls)
                + Refuse<ColliderRecord>(SnapshotSection.Colliders) + Refuse<ForceRecord>(SnapshotSection.Forces)
                + Refuse<ReactionsRecord>(SnapshotSection.Reactions) + Refuse<TakenRecord>(SnapshotSection.TakenColliders);
            refused += sleeps ? Refuse<RestRecord>(SnapshotSection.Rest) + Refuse<FieldRegion>(SnapshotSection.Fields)
                : Refuse<EmitterRecord>(SnapshotSection.Emitters) + Refuse<DrainRecord>(SnapshotSection.Drains);
            Assert.That(refused, Is.GreaterThan(300));

            int Refuse<T>(SnapshotSection section) where T : struct
            {
                T[] records = FluidSnapshot.FromBytes(bytes).Contents.Values<T>(section).ToArray();
                Assert.That(records, Is.Not.Empty, section.ToString());
                int count = 0;
                foreach ((string field, object changed) in SnapshotBytesTests.Damaged(records[0]))
                {
                    if (AnyBits.Contains(field))
                        continue;
                    SnapshotContents contents = FluidSnapshot.FromBytes(bytes).Contents;
                    var all = (T[])records.Clone();
                    all[0] = (T)changed;
                    contents.SetValues<T>(section, all);
                    string refusal = SnapshotBytesTests.Refusal(SnapshotFormat.Write(contents));
                    Assert.That(refusal, Does.StartWith("These bytes are not a snapshot that can be read: ").And.Contain("use others"),
                        $"{typeof(T).Name}{field}");
                    count++;
                }
                return count;
            }
        }

        [Test]
        public void A_number_of_a_floating_body_that_cannot_be_is_refused()
        {
            SnapshotBody body = Body();
            AssertTaken(body);
            foreach ((string field, object changed) in SnapshotBytesTests.Damaged(body.record))
            {
                SnapshotBody damaged = Body();
                damaged.record = (BodyRecord)changed;
                AssertRefused(damaged, field);
            }
            foreach ((string field, object changed) in SnapshotBytesTests.Damaged(body.water.answers[0].frame))
            {
                SnapshotBody damaged = Body();
                damaged.water.answers[0].frame = (QueryFrame)changed;
                AssertRefused(damaged, field);
            }
            foreach (float value in new[] { float.NaN, float.PositiveInfinity })
            {
                AssertRefused(With(b => b.water.points[1] = new float3(0f, value, 0f)), "point");
                AssertRefused(With(b => b.water.answers[0].points[0].z = value), "point of an answer");
                AssertRefused(With(b => b.water.answers[0].shiftSince.y = value), "shift");
                AssertRefused(With(b => b.water.unneeded = value), "time");
            }
            AssertRefused(With(b => b.water.answers[0].frames = -1), "frames");
            AssertRefused(With(b => b.water.answers[0].frames = 1001), "frames");
            AssertRefused(With(b => b.water.answers[0].words = new uint[Queries.ProbeWords - 1]), "words");
            AssertRefused(With(b => b.water.answers[0].points = new float4[65]), "points");
            AssertRefused(With(b => b.path = new string('a', 4097)), null);      // cut as it is written
        }

        [Test]
        public void Floating_bodies_that_are_cut_off_or_too_long_are_refused()
        {
            byte[] bytes = SnapshotBodies.Write(new List<SnapshotBody> { Body(), Body() });
            for (int length = 0; length < bytes.Length; length++)
                Assert.Throws<InvalidDataException>(() => SnapshotBodies.Read(bytes.AsSpan(0, length).ToArray()), $"{length} bytes");
            var longer = new byte[bytes.Length + 1];
            bytes.CopyTo(longer, 0);
            Assert.That(Assert.Throws<InvalidDataException>(() => SnapshotBodies.Read(longer)).Message, Does.Contain("a floating body cannot be"));
            foreach (int count in new[] { -1, 65537, 3 })
            {
                BitConverter.GetBytes(count).CopyTo(bytes, 0);
                Assert.That(Assert.Throws<InvalidDataException>(() => SnapshotBodies.Read(bytes)).Message, Does.Contain("a floating body"));
            }
        }

        static void AssertTaken(SnapshotBody body)
        {
            SnapshotBody read = SnapshotBodies.Read(SnapshotBodies.Write(new List<SnapshotBody> { body }))[0];
            Assert.That(read.path, Is.EqualTo(body.path));
            Assert.That(read.record, Is.EqualTo(body.record));
            Assert.That(read.water.points, Is.EqualTo(body.water.points));
            Assert.That(read.water.answers[0].frame, Is.EqualTo(body.water.answers[0].frame));
            Assert.That(read.water.answers[0].words, Is.EqualTo(body.water.answers[0].words));
            Assert.That(read.water.answers[0].points, Is.EqualTo(body.water.answers[0].points));
        }

        static void AssertRefused(SnapshotBody damaged, string what)
        {
            byte[] bytes = SnapshotBodies.Write(new List<SnapshotBody> { damaged });
            if (what == null)
                Assert.That(SnapshotBodies.Read(bytes)[0].path, Has.Length.EqualTo(4096));
            else
                Assert.That(Assert.Throws<InvalidDataException>(() => SnapshotBodies.Read(bytes), what).Message,
                    Does.Contain("a floating body cannot be"), what);
        }

        static SnapshotBody With(Action<SnapshotBody> change)
        {
            SnapshotBody body = Body();
            change(body);
            return body;
        }

        static SnapshotBody Body()
        {
            var body = new SnapshotBody { path = "Boats/Boat", water = new SnapshotWater { unneeded = 0.1f } };
            body.record.pose = body.record.shown = new PoseRecord(new RigidPose(1f, quaternion.identity));
            body.record.flags = BodyRecord.Awaits;
            body.record.awaitedTime = 0.1f;
            body.water.points.Add(new float3(1f, 2f, 3f));
            body.water.points.Add(new float3(2f, 2f, 3f));
            body.water.answers.Add(new SnapshotAnswer
            {
                frame = new QueryFrame { step = 3, time = 0.5, rotation = Quaternion.identity, spacing = 0.05f, density = 1000f, up = Vector3.up },
                frames = 2,
                points = new[] { new float4(1f, 2f, 3f, 0f) },
                words = new uint[Queries.ProbeWords],
            });
            return body;
        }
    }
}
