using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Texts of the window and the inspector about meshes, bakes and fields.</summary>
    static class BakeTexts
    {
        public static string Of(Vector3Int resolution) => Invariant($"{resolution.x} x {resolution.y} x {resolution.z}");

        public static string MebiBytes(long bytes)
            => bytes < 10485760 ? Invariant($"{bytes / 1048576.0:0.0} MiB") : Invariant($"{bytes / 1048576.0:N0} MiB");

        public static string Of(in MeshSdfEstimate estimate) =>
            $"{Of(estimate.Resolution)} voxels of {Meters(estimate.VoxelSize)}: {MebiBytes(estimate.TotalBytes)} while it bakes, the " +
            $"texture at most {MebiBytes(estimate.TextureBytes)}, twice";

        public static string Of(SdfBake bake) =>
            $"{Of(bake.Resolution)} voxels of {Meters(bake.VoxelSize)}, {Of(bake.Sign, bake.ShellThickness)}, " +
            Invariant($"{(bake.Format == SdfFormat.Half ? 16 : 32)} bits a voxel, storage error at most ") +
            $"{Voxels(bake.StorageError, bake.VoxelSize)}";

        /// <summary>The head of a report: how large, whether closed, and the counts that are not 0.</summary>
        public static string Of(MeshReport report)
        {
            var parts = new List<string> { $"{Number(report.Triangles)} triangles", report.IsWatertight ? "watertight" : "not watertight" };
            void Count(int count, string what)
            {
                if (count > 0)
                    parts.Add($"{Number(count)} {what}");
            }
            Count(report.Holes, "holes");
            Count(report.BoundaryEdges, "open edges");
            Count(report.NonManifoldEdges, "edges of more than two triangles");
            Count(report.FlippedTriangles, "flipped triangles");
            Count(report.ZeroAreaTriangles, "triangles without area");
            Count(report.SelfIntersections, "pairs that cross");
            Count(report.NonFiniteVertices, "vertices that are not finite");
            Count(report.SubMeshes > 1 ? report.SubMeshes : 0, "submeshes");
            return string.Join(", ", parts);
        }

        /// <summary>Describes a button that takes the remedy of a loss.</summary>
        /// <param name="settings">Those with which there is the loss.</param>
        public static string Of(in MeshSdfSettings remedy, in MeshSdfSettings settings) =>
            remedy.leaveOutFar != settings.leaveOutFar ? "Leave Out Far" : remedy.sign != settings.sign ? "Bake as Open Shell"
            : $"Use Voxels of {Meters(remedy.voxelSize)}";

        /// <summary>Facts of a field, for its inspector.</summary>
        public static IEnumerable<(string label, string text)> Facts(SignedDistanceField field)
        {
            Vector3Int n = field.Resolution;
            long voxels = (long)n.x * n.y * n.z, each = field.Texture != null && field.Texture.format == TextureFormat.RHalf ? 2 : 4;
            yield return ("Resolution", Invariant($"{Of(n)} = {voxels:N0} voxels"));
            yield return ("Voxel Size", Meters(field.VoxelSize));
            yield return ("Bounds", $"{Of(field.Bounds.min)} to {Of(field.Bounds.max)} m");
            yield return ("Sign", Of(field.Sign, field.ShellThickness));
            yield return ("Format", Invariant($"{8 * each} bits a voxel, error ") +
                $"{(float.IsNaN(field.StorageError) ? "unknown" : "at most " + Voxels(field.StorageError, field.VoxelSize))}");
            yield return ("Memory", $"{MebiBytes(voxels * each)} on the GPU and as much again off it");
            yield return ("Volume Inside", Invariant($"{field.Volume:G4} m³"));
            yield return ("Source Mesh", SourceOf(field));
            yield return ("Baked With", Of(field.Settings));
            yield return ("Version", Invariant($"{field.Version} of {SignedDistanceField.CurrentVersion}"));
        }

        static string SourceOf(SignedDistanceField field)
        {
            Mesh mesh = FieldAssets.MeshOf(field, out _);
            return mesh != null ? $"{mesh.name} in {AssetDatabase.GetAssetPath(mesh)}" : field.SourceMesh == "" ? "unknown"
                : $"gone (GUID {field.SourceMesh})";
        }

        static string Of(in MeshSdfSettings settings) =>
            (settings.voxelSize > 0f ? $"voxels of {Meters(settings.voxelSize)}"
                : Invariant($"{settings.resolution} voxels along the longest axis")) +
            Invariant($", {settings.padding} of padding, sign ") +
            $"{(settings.sign == MeshSdfSign.Automatic ? "automatic" : settings.sign == MeshSdfSign.OpenShell ? "open shell" : "winding number")}"
            + (settings.leaveOutFar ? ", without what is far" : "");

        static string Of(MeshSdfSign sign, float shell) => sign == MeshSdfSign.OpenShell ? $"open shell, {Meters(shell)} thick" : "winding number";

        static string Of(Vector3 v) => Invariant($"({v.x:G4}, {v.y:G4}, {v.z:G4})");

        static string Meters(float length) => Invariant($"{length:G4} m");

        static string Voxels(float error, float voxel) => Invariant($"{error / voxel:G2} voxel");

        static string Number(int value) => Invariant($"{value:N0}");
    }
}
