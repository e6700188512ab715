using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Findings of a <see cref="MeshCheck"/>, in numbers and in words.</summary>
    public sealed class MeshReport
    {
        /// <summary>Holes of more than this fraction of the whole surface make a mesh an open surface.</summary>
        public const double MaxHoleFraction = 0.1;

        // A volume below this fraction of the area's power 3/2 is none: both sides of a sheet.
        const double MinVolume = 1e-6;

        readonly MeshLosses losses;
        readonly int flatHoles;

        internal MeshReport(TriangleMesh mesh, MeshEdges edges, int nonFiniteVertices, in SelfIntersections.Count intersections,
            MeshLosses losses, MeshReport withoutFar)
        {
            this.losses = losses;
            WithoutFar = withoutFar;
            Name = mesh.Name;
            Triangles = mesh.TriangleCount;
            Vertices = mesh.Vertices.Length;
            SubMeshes = mesh.SubMeshes;
            SubMeshesWithoutTriangles = mesh.SubMeshesWithoutTriangles;
            NonFiniteVertices = nonFiniteVertices;
            NonFiniteTriangles = edges.Triangles.NonFinite;
            DuplicateVertices = mesh.Vertices.Length - edges.Vertices;
            JoinedVertices = edges.JoinedVertices;
            JoinDistance = edges.JoinDistance;
            ZeroAreaTriangles = edges.Triangles.WithoutArea;
            BoundaryEdges = edges.BoundaryEdges;
            Holes = edges.Holes;
            flatHoles = edges.FlatHoles;
            NonManifoldEdges = edges.NonManifoldEdges;
            InconsistentEdges = edges.InconsistentEdges;
            FlippedTriangles = edges.TurnedTriangles;
            InvertedParts = edges.InvertedParts;
            Parts = edges.Parts.Count;
            SelfIntersections = intersections.Pairs;
            SelfIntersectionsChecked = intersections.Checked;
            Area = edges.Triangles.Area;
            Bounds = edges.Triangles.Bounds;
            SignedVolume = edges.SignedVolume;
            HoleFraction = HoleFractionOf(edges);
            Sign = SignOf(edges);
            Problem = ProblemOf(edges.Triangles);
            Texts = Describe();
        }

        /// <summary>Name of the mesh that was checked.</summary>
        public string Name { get; }
        /// <summary>Triangles of all its submeshes.</summary>
        public int Triangles { get; }
        /// <summary>Vertices of the mesh.</summary>
        public int Vertices { get; }
        /// <summary>Submeshes, with those of points and lines.</summary>
        public int SubMeshes { get; }

        /// <summary>Submeshes of points or lines.</summary>
        public int SubMeshesWithoutTriangles { get; }

        /// <summary>Vertices with a coordinate that is NaN or infinite, and triangles that use one.</summary>
        public int NonFiniteVertices { get; }
        /// <summary>Triangles that use a vertex with a coordinate that is NaN or infinite. They are left out of the bake.</summary>
        public int NonFiniteTriangles { get; }

        /// <summary>Vertices where another is, as seams of normals and textures make them.</summary>
        public int DuplicateVertices { get; }

        /// <summary>Corners of edges that would be open, within <see cref="JoinDistance"/> of another: taken as one with it.</summary>
        public int JoinedVertices { get; }

        /// <summary>Most that two corners lie apart, m, that count as one: 1e-5 of the mesh's size. At most a hundredth of the edges there,
        /// and at least what the coordinates are rounded to far from the origin.</summary>
        public double JoinDistance { get; }

        /// <summary>Triangles thinner than 1e-10 of their longest edge.</summary>
        public int ZeroAreaTriangles { get; }

        /// <summary>Edges that only one triangle has.</summary>
        public int BoundaryEdges { get; }

        /// <summary>Loops of boundary edges; loops that touch in a vertex are one.</summary>
        public int Holes { get; }

        /// <summary>Area of flat covers over the holes as a fraction of the whole surface with them; 0 for a closed mesh.</summary>
        public double HoleFraction { get; }

        /// <summary>Edges of more than two triangles.</summary>
        public int NonManifoldEdges { get; }

        /// <summary>Edges whose two triangles face different sides.</summary>
        public int InconsistentEdges { get; }

        /// <summary>Triangles that face the other side than most of what they hang together with.</summary>
        public int FlippedTriangles { get; }

        /// <summary>Closed parts that face the other side than the rest, and lie in no other part.</summary>
        public int InvertedParts { get; }

        /// <summary>Parts of triangles that hang together by their corners.</summary>
        public int Parts { get; }

        /// <summary>Pairs of triangles that cross each other, without those with a common vertex and without those in one plane.</summary>
        public int SelfIntersections { get; }

        /// <summary>Fraction of the pairs in question that were tested, 0 to 1: below 1 for meshes that would take too long.</summary>
        public float SelfIntersectionsChecked { get; }

        /// <summary>m².</summary>
        public double Area { get; }

        /// <summary>Bounds of the triangles that are baked, m, in the frame of the mesh.</summary>
        public Bounds Bounds { get; }

        /// <summary>m³, with flipped triangles turned; negative for a mesh that is inside out. Means little for an open one.</summary>
        public double SignedVolume { get; }

        /// <summary>Whether the triangles of a closed mesh face inwards.</summary>
        public bool IsInsideOut => Sign == MeshSdfSign.WindingNumber && SignedVolume < 0;

        /// <summary>Whether no edge is open and none has more than two triangles.</summary>
        public bool IsWatertight => Triangles > 0 && BoundaryEdges == 0 && NonManifoldEdges == 0 && NonFiniteVertices == 0;

        /// <summary>Sign method that Automatic chooses.</summary>
        public MeshSdfSign Sign { get; }

        /// <summary>Why the mesh cannot be baked, with the remedy; null if it can.</summary>
        public string Problem { get; }

        /// <summary>A sentence for everything found: what, in which number, and what the baker does about it. Empty for a mesh without a
        /// fault.</summary>
        public IReadOnlyList<string> Texts { get; }

        /// <summary>The report of the mesh without what <see cref="MeshSdfSettings.leaveOutFar"/> leaves out; null where that is nothing.</summary>
        public MeshReport WithoutFar { get; }

        /// <summary>The report of what a bake with these settings takes.</summary>
        internal MeshReport Of(in MeshSdfSettings settings) => settings.leaveOutFar && WithoutFar != null ? WithoutFar : this;

        /// <summary>Lists what a bake with these settings would not represent, and why, with the remedy: parts that are thinner than a voxel or
        /// have no inside, and what makes the box and the voxels so large. Reads no mesh. Empty where all is represented, and where nothing
        /// can be baked.</summary>
        public IReadOnlyList<MeshLoss> LossesOf(in MeshSdfSettings settings)
        {
            var found = new List<MeshLoss>();
            if (Problem != null || !settings.Validate(out _))
                return found;
            if (WithoutFar != null)
                losses.AddFar(found, settings, MeshSdfBaker.Estimate(this, settings), WithoutFar);
            MeshReport taken = Of(settings);
            if (taken.Problem == null)
                taken.losses.Add(found, settings, taken);
            return found;
        }

        internal static MeshSdfSign SignOf(MeshEdges edges)
        {
            return HoleFractionOf(edges) <= MaxHoleFraction && HasVolume(edges.SignedVolume, edges.Triangles.Area) ? MeshSdfSign.WindingNumber
                : MeshSdfSign.OpenShell;
        }

        /// <summary>Whether a closed surface is more than two sides of a sheet.</summary>
        internal static bool HasVolume(double volume, double area) => System.Math.Abs(volume) > MinVolume * System.Math.Pow(area, 1.5);

        static double HoleFractionOf(MeshEdges edges) => edges.HoleArea > 0 ? edges.HoleArea / (edges.HoleArea + edges.Triangles.Area) : 0;

        /// <summary>Why triangles cannot be baked; null if they can.</summary>
        internal static string ProblemOf(BakedTriangles triangles)
        {
            TriangleMesh mesh = triangles.Mesh;
            if (mesh.TriangleCount == 0)
                return $"'{mesh.Name}' has no triangles: there is nothing to bake.";
            if (triangles.NonFinite > 0)
                return $"'{mesh.Name}': {Number(triangles.NonFinite)} of {Number(mesh.TriangleCount)} triangles have vertices that are " +
                    $"no finite numbers: repair the mesh.";
            if (triangles.Count == 0)
                return $"'{mesh.Name}': none of its {Number(mesh.TriangleCount)} triangles has an area: repair the mesh, or scale it up.";
            return null;
        }

        List<string> Describe()
        {
            var texts = new List<string>();
            if (Problem != null)
                texts.Add(Problem);
            if (SubMeshes > 1)
                texts.Add($"{Number(SubMeshes)} submeshes: baked together as one surface.");
            if (SubMeshesWithoutTriangles > 0)
                texts.Add($"{Number(SubMeshesWithoutTriangles)} submeshes of points or lines: left out.");
            if (NonFiniteVertices > 0 && NonFiniteTriangles == 0)
                texts.Add($"{Number(NonFiniteVertices)} vertices are not finite numbers, but no triangle uses them: left out.");
            if (DuplicateVertices > 0)
                texts.Add($"{Number(DuplicateVertices)} of {Number(Vertices)} vertices lie exactly at another's position: taken as one to " +
                    $"find edges; the distance is not touched.");
            if (JoinedVertices > 0)
                texts.Add($"{Number(JoinedVertices)} corners of open edges lie almost at another's position, within {Meters(JoinDistance)} or what " +
                    $"their coordinates are rounded to: taken as one to find edges; the distance is not touched.");
            if (ZeroAreaTriangles > 0)
                texts.Add($"{Number(ZeroAreaTriangles)} triangles have no area: left out.");
            if (FlippedTriangles > 0)
                texts.Add($"{Number(FlippedTriangles)} triangles face the other side than their neighbors, over " +
                    $"{Number(InconsistentEdges)} edges: turned over.");
            else if (InconsistentEdges > 0)
                texts.Add($"{Number(InconsistentEdges)} edges have triangles that face different sides, and turning some over does not " +
                    $"help: the sign may be wrong near them.");
            if (IsInsideOut)
                texts.Add("The mesh is inside out: turned over as a whole.");
            if (InvertedParts > 0)
                texts.Add($"{Number(InvertedParts)} of {Number(Parts)} parts face the other side than the rest and lie in no other part: " +
                    "turned over.");
            if (NonManifoldEdges > 0)
                texts.Add($"{Number(NonManifoldEdges)} edges have more than two triangles: the winding number copes with them; parts " +
                    $"that meet there are not compared.");
            if (Sign == MeshSdfSign.OpenShell)
                texts.Add(HoleFraction > 0
                    ? $"{Number(Holes)} holes with {Number(BoundaryEdges)} edges, {Percent(HoleFraction)} of the surface: baked as an " +
                    $"open shell of a thickness. To close the holes instead, set the sign to winding number."
                    : "The mesh has no volume: baked as an open shell of a thickness.");
            else if (BoundaryEdges > 0 && flatHoles == Holes)
                texts.Add($"{Number(BoundaryEdges)} open edges bound no area, as where a corner lies on another triangle's edge: as good as closed.");
            else if (BoundaryEdges > 0)
                texts.Add($"{Number(Holes)} holes with {Number(BoundaryEdges)} edges, {Percent(HoleFraction)} of the surface: closed " +
                    $"smoothly. To keep the surface open, set the sign to open shell.");
            if (SelfIntersections > 0)
                texts.Add($"{Number(SelfIntersections)} pairs of triangles cross each other: inside is what is inside of any part, but " +
                    $"the distance there is to the nearest triangle, even one that lies inside.");
            if (SelfIntersectionsChecked < 1f)
                texts.Add($"The mesh is large: {Percent(SelfIntersectionsChecked)} of it was looked through for triangles that cross each other.");
            return texts;
        }

        static string Meters(double length) => Invariant($"{length:G3} m");
        static string Number(int value) => Invariant($"{value:N0}");
        static string Percent(double fraction) => Invariant($"{100 * fraction:0.#} %");
    }
}
