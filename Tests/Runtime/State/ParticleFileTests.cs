using System;
using System.Collections;
using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Particles into files. That other programs read them is tested by the host, with their own readers.</summary>
    public class ParticleFileTests
    {
        const int PlyParticle = 7 * 4 + 1 + 4;

        string folder;

        [SetUp]
        public void MakeFolder() => folder = Path.Combine(Path.GetTempPath(), "rill-sequence-" + Guid.NewGuid().ToString("N"));

        [TearDown]
        public void RemoveFolder()
        {
            if (Directory.Exists(folder))
                Directory.Delete(folder, true);
        }

        [UnityTest]
        public IEnumerator A_sequence_writes_the_particles_of_each_moment_without_waiting()
        {
            using (SourceScene scene = new SourceScene(new Vector3(1f, 1f, 0.8f), 0.05f, 4000).Fill(0.2f).Step(2))
            {
                scene.Fluid.Inertial = false;       // the move causes no jerk
                scene.Fluid.transform.SetPositionAndRotation(new Vector3(3f, 1f, -2f), Quaternion.Euler(0f, 90f, 0f));
                using (var sequence = new ParticleSequence(scene.Fluid, folder, "water", ParticleFileFormat.Ply))
                {
                    scene.Step();
                    ParticleState first = scene.Read();
                    sequence.Capture();
                    scene.Step();
                    sequence.Capture();
                    Assert.That(sequence.Written, Is.Zero, "nothing waited for");
                    scene.Fluid.enabled = false;        // what is pending comes all the same
                    for (int frame = 0; frame < 30 && sequence.Written < 2; frame++)
                        yield return null;
                    Assert.That((sequence.Captured, sequence.Written, sequence.Problem), Is.EqualTo((2, 2, (string)null)));
                    Assert.That(Directory.GetFiles(folder).Select(Path.GetFileName),
                        Is.EquivalentTo(new[] { "water_000000.ply", "water_000001.ply" }));

                    byte[] bytes = File.ReadAllBytes(Path.Combine(folder, "water_000000.ply"));
                    int body = bytes.Length - first.Count * PlyParticle;
                    Assert.That(Encoding.ASCII.GetString(bytes, 0, body),
                        Does.StartWith("ply\n").And.EndWith("end_header\n").And.Contain($"element vertex {first.Count}\n"));
                    for (int i = 0; i < first.Count; i += 37)
                    {
                        float3 position = new float3(Number(bytes, body, i, 0), Number(bytes, body, i, 1), Number(bytes, body, i, 2));
                        float3 expected = scene.Fluid.DomainToWorld.MultiplyPoint3x4(first.positions[i].xyz);
                        Assert.That(math.distance(position, expected), Is.LessThan(1e-5f), $"particle {i}");
                        float3 velocity = new float3(Number(bytes, body, i, 3), Number(bytes, body, i, 4), Number(bytes, body, i, 5));
                        Assert.That(math.distance(velocity, (float3)scene.Fluid.DomainToWorld.MultiplyVector(first.velocities[i].xyz)),
                            Is.LessThan(1e-4f));
                        Assert.That(Number(bytes, body, i, 6), Is.EqualTo(1000f * first.velocities[i].w).Within(0.01f), "kg/m³");
                        Assert.That(BitConverter.ToUInt32(bytes, body + i * PlyParticle + 29), Is.EqualTo(first.ids[i]));
                    }
                }
            }
        }

        [Test]
        public void Arrays_of_other_lengths_are_refused()
        {
            ArgumentException refusal = Assert.Throws<ArgumentException>(() => new ParticleFrame(new float3[2], new float3[3], new float[2],
                new byte[2], new uint[2], 0.0));
            Assert.That(refusal.Message, Does.Contain("2 positions with 3 velocities"));
            Assert.Throws<ArgumentNullException>(() => new ParticleFrame(null, new float3[0], new float[0], new byte[0], new uint[0], 0.0));
        }

        [UnityTest]
        public IEnumerator A_file_that_cannot_be_written_is_logged_once_and_the_sequence_goes_on()
        {
            using (SourceScene scene = new SourceScene(Vector3.one, 0.05f, 500).Fill(0.05f).Step())
            using (var sequence = new ParticleSequence(scene.Fluid, folder, "water", ParticleFileFormat.Vtk))
            {
                Directory.CreateDirectory(Path.Combine(folder, "water_000000.vtk"));        // in the file's place
                LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("water_000000.vtk' was not written"));
                sequence.Capture();
                sequence.Capture();
                for (int frame = 0; frame < 30 && sequence.Written < 1; frame++)
                    yield return null;
                Assert.That(sequence.Written, Is.EqualTo(1));
                Assert.That(sequence.Problem, Does.Contain("water_000000.vtk"));
            }
        }

        static float Number(byte[] bytes, int body, int particle, int number)
            => BitConverter.ToSingle(bytes, body + particle * PlyParticle + 4 * number);
    }
}
