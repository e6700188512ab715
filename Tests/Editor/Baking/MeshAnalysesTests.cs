using System.Collections.Generic;
using System.Linq;
using System.Threading;
using NUnit.Framework;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>Meshes are analyzed once, beside the editor, and again when they have changed.</summary>
    public class MeshAnalysesTests
    {
        // Milliseconds in which a thread has surely looked through a cube.
        const int Patience = 30000;

        readonly List<Mesh> made = new List<Mesh>();
        MeshAnalyses analyses;

        [SetUp]
        public void Begin() => analyses = new MeshAnalyses();

        [TearDown]
        public void End()
        {
            analyses.Clear();
            made.ForEach(Object.DestroyImmediate);
            made.Clear();
        }

        Mesh Box(float size = 1f)
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            Mesh source = cube.GetComponent<MeshFilter>().sharedMesh;
            var mesh = new Mesh { name = "Box", vertices = source.vertices.Select(v => size * v).ToArray(), triangles = source.triangles };
            Object.DestroyImmediate(cube);
            made.Add(mesh);
            return mesh;
        }

        static bool GoOn(float fraction, string stage) => true;

        MeshAnalysis[] Analyzed(params Mesh[] meshes)
        {
            MeshAnalysis[] wanted = meshes.Select(analyses.Of).ToArray();
            Assert.That(SpinWait.SpinUntil(() =>
            {
                analyses.Update(wanted);
                return wanted.All(analysis => analysis.IsDone);
            }, Patience));
            return wanted;
        }

        [Test]
        public void A_mesh_is_analyzed_once_for_as_long_as_it_stays_the_same()
        {
            Mesh one = Box(), two = Box(2f);
            MeshAnalysis[] first = Analyzed(one, two), again = Analyzed(two, one, two);
            Assert.That(again, Is.EqualTo(new[] { first[1], first[0], first[1] }));
            Assert.That(first.All(analysis => analysis.Report.IsWatertight && analysis.Problem == null));
            Assert.That(analyses.Started, Is.EqualTo(2));
        }

        [Test]
        public void A_mesh_that_has_changed_is_analyzed_again()
        {
            Mesh mesh = Box();
            MeshAnalysis before = Analyzed(mesh)[0];
            mesh.vertices = mesh.vertices.Select(v => 3f * v).ToArray();
            mesh.RecalculateBounds();
            MeshAnalysis after = Analyzed(mesh)[0];
            Assert.That(after, Is.Not.SameAs(before));
            Assert.That(after.Report.Bounds.size.x, Is.EqualTo(3f * before.Report.Bounds.size.x).Within(1e-4f));
            Assert.That(analyses.Started, Is.EqualTo(2));
        }

        [Test]
        public void A_change_that_is_not_seen_without_reading_the_mesh_is_seen_by_the_bake()
        {
            Mesh mesh = Box();
            MeshAnalysis analysis = Analyzed(mesh)[0];
            MeshReport before = analysis.Report;
            Assert.That(analysis.Finish(GoOn, out _));
            Assert.That(analysis.Report, Is.SameAs(before));
            int[] triangles = mesh.triangles;
            (triangles[0], triangles[1]) = (triangles[1], triangles[0]);
            mesh.triangles = triangles;
            Assert.That(analysis.IsCurrent, "as many of all, where they were");
            Assert.That(analysis.Finish(GoOn, out TriangleMesh now));
            Assert.That(analysis.Report.FlippedTriangles, Is.EqualTo(1));
            Assert.That(now.Triangles, Is.EqualTo(triangles));
        }

        [Test]
        public void Nothing_is_begun_while_it_is_paused_or_when_all_is_known()
        {
            MeshAnalysis[] wanted = { analyses.Of(Box()) };
            analyses.Pause();
            Assert.That(analyses.Update(wanted), Is.False);
            Assert.That((analyses.Started, wanted[0].IsRunning), Is.EqualTo((0, false)));
            analyses.Resume();
            Assert.That(analyses.Update(wanted), Is.True);
            Assert.That(analyses.Started, Is.EqualTo(1));
            Analyzed(wanted[0].Mesh);
            Assert.That(analyses.Update(wanted), Is.False, "nothing new to show");
            Assert.That(analyses.Started, Is.EqualTo(1));
        }

        [Test]
        public void A_canceled_analysis_knows_nothing_and_can_be_finished_later()
        {
            var analysis = new MeshAnalysis(Box());
            Assert.That(analysis.Finish((fraction, stage) => false, out _), Is.False);
            Assert.That((analysis.IsDone, analysis.Report), Is.EqualTo((false, (MeshReport)null)));
            analysis.Start();
            analysis.Cancel();
            Assert.That(SpinWait.SpinUntil(analysis.Poll, Patience));
            Assert.That(analysis.Finish(GoOn, out _));
            Assert.That(analysis.Report, Is.Not.Null);
        }

        [Test]
        public void A_bake_waits_for_an_analysis_that_is_under_way()
        {
            var analysis = new MeshAnalysis(Box());
            analysis.Start();
            Assert.That(analysis.Finish(GoOn, out TriangleMesh triangles));
            Assert.That((analysis.Report.Triangles, triangles.TriangleCount, analysis.IsRunning), Is.EqualTo((12, 12, false)));
        }
    }
}
