using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Host.Commands;
using NUnit.Framework;
using Rill;
using Unity.Mathematics;

namespace Host.Tests
{
    /// <summary>Files of particles as programs read them that others wrote: VTK's own readers, and meshio (Debian packages python3-vtk9 and
    /// python3-meshio).</summary>
    public sealed class ParticleReaderTests
    {
        const string Python = "/usr/bin/python3";       // Debian's, which has Debian's packages

        internal const string ReadVtk = @"
import sys, vtk
reader = vtk.vtkPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.ReadAllScalarsOn(); reader.ReadAllVectorsOn(); reader.ReadAllFieldsOn()
reader.Update()
if reader.GetErrorCode() != 0: sys.exit('error %d' % reader.GetErrorCode())
data = reader.GetOutput()
points = data.GetPointData()
n = data.GetNumberOfPoints()
print(n, data.GetNumberOfVerts(), repr(data.GetFieldData().GetArray('TIME').GetValue(0)))
named = {name: points.GetArray(name) for name in ('velocity', 'density', 'phase', 'id')}
for i in range(n):
    print(*[repr(x) for x in data.GetPoint(i) + named['velocity'].GetTuple3(i)], repr(named['density'].GetValue(i)), named['phase'].GetValue(i), named['id'].GetValue(i))
";

        internal const string ReadPly = @"
import sys, meshio
mesh = meshio.read(sys.argv[1])
d = mesh.point_data
n = len(mesh.points)
print(n)
for i in range(n):
    print(*[repr(float(x)) for x in mesh.points[i]], *[repr(float(d[k][i])) for k in ('vx', 'vy', 'vz', 'density')], int(d['phase'][i]), int(d['id'][i]))
";

        const string ReadPlyByVtk = @"
import sys, vtk
reader = vtk.vtkPLYReader()
reader.SetFileName(sys.argv[1])
reader.Update()
data = reader.GetOutput()
print(data.GetNumberOfPoints())
for i in range(data.GetNumberOfPoints()):
    print(*[repr(x) for x in data.GetPoint(i)])
";

        string folder;

        [SetUp]
        public void MakeFolder() => folder = Directory.CreateTempSubdirectory("rill-particles-").FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        [TestCase(1)]
        [TestCase(997)]
        public void VTK_reads_what_was_written(int count)
        {
            ParticleFrame frame = Random(count);
            string[] lines = Read(ReadVtk, Write(frame, ParticleFileFormat.Vtk));
            string[] head = lines[0].Split(' ');
            Assert.That((head[0], head[1]), Is.EqualTo((Text(count), Text(count))), "points and vertices");
            Assert.That(double.Parse(head[2], CultureInfo.InvariantCulture), Is.EqualTo(frame.Time));
            AssertSame(lines.Skip(1), frame, 9);
        }

        [TestCase(1)]
        [TestCase(997)]
        public void A_reader_of_PLY_reads_what_was_written(int count)
        {
            ParticleFrame frame = Random(count);
            string file = Write(frame, ParticleFileFormat.Ply);
            string[] lines = Read(ReadPly, file);
            Assert.That(lines[0], Is.EqualTo(Text(count)));
            AssertSame(lines.Skip(1), frame, 9);
            AssertSame(Read(ReadPlyByVtk, file).Skip(1), frame, 3);
        }

        [Test]
        public void VTK_reads_a_frame_without_particles()
        {
            string[] head = Read(ReadVtk.Replace("named = ", "sys.exit(0)\nnamed = "), Write(Random(0), ParticleFileFormat.Vtk))[0].Split(' ');
            Assert.That((head[0], head[1]), Is.EqualTo(("0", "0")));
        }

        // The detector: what is not as it was written is seen.
        [Test]
        public void A_file_with_one_byte_changed_is_seen()
        {
            ParticleFrame frame = Random(20);
            string file = Write(frame, ParticleFileFormat.Vtk);
            byte[] bytes = File.ReadAllBytes(file);
            bytes[^5] ^= 1;         // of the last id
            File.WriteAllBytes(file, bytes);
            Assert.Throws<AssertionException>(() =>
            {
                using (new NUnit.Framework.Internal.TestExecutionContext.IsolatedContext())
                    AssertSame(Read(ReadVtk, file).Skip(1), frame, 9);
            });
        }

        [Test]
        public void A_format_that_is_none_is_refused_by_name()
            => Assert.That(Assert.Throws<HostException>(() => ExportCommand.FormatOf("obj")).Message,
            Does.Contain("--format obj").And.Contain("ply or vtk"));

        static ParticleFrame Random(int count)
        {
            var random = new System.Random(count + 3);
            float3[] Vectors() => Enumerable.Range(0, count)
                .Select(_ => new float3((float)random.NextDouble() - 0.5f, 1e6f * (float)random.NextDouble(),
                1e-6f * (float)random.NextDouble())).ToArray();
            float[] densities = Enumerable.Range(0, count).Select(_ => 1000f * (float)random.NextDouble()).ToArray();
            byte[] phases = Enumerable.Range(0, count).Select(_ => (byte)random.Next(8)).ToArray();
            uint[] ids = Enumerable.Range(0, count).Select(i => uint.MaxValue - (uint)(3 * i)).ToArray();
            return new ParticleFrame(Vectors(), Vectors(), densities, phases, ids, 1.0 / 3.0);
        }

        string Write(ParticleFrame frame, ParticleFileFormat format)
        {
            string file = Path.Combine(folder, "particles" + ParticleFile.Extension(format));
            using (FileStream stream = File.Create(file))
                ParticleFile.Write(stream, frame, format);
            return file;
        }

        static void AssertSame(IEnumerable<string> lines, ParticleFrame frame, int columns)
        {
            string[] all = lines.ToArray();
            Assert.That(all, Has.Length.EqualTo(frame.Count));
            for (int i = 0; i < frame.Count; i++)
            {
                double[] expected = { frame.Positions[i].x, frame.Positions[i].y, frame.Positions[i].z, frame.Velocities[i].x,
                    frame.Velocities[i].y, frame.Velocities[i].z, frame.Densities[i], frame.Phases[i], frame.Ids[i] };
                double[] read = all[i].Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray();
                Assert.That(read, Is.EqualTo(expected.Take(columns)), $"particle {i}");
            }
        }

        static string Text(int number) => number.ToString(CultureInfo.InvariantCulture);

        /// <summary>The lines that a script of Python writes about a file.</summary>
        internal static string[] Read(string script, string file)
        {
            var start = new ProcessStartInfo(Python, new[] { "-c", script, file }) { RedirectStandardOutput = true, RedirectStandardError = true };
            using Process process = Process.Start(start);
            var errors = process.StandardError.ReadToEndAsync();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.Zero, errors.Result);
            Assert.That(errors.Result, Does.Not.Contain("ERR"), "VTK tells of errors there");
            return output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        }
    }
}
