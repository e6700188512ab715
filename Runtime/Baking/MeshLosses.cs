using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Tells what of a mesh a bake would not represent.</summary>
    sealed class MeshLosses
    {
        // Voxels that a part takes across at least, of which samples between voxels make a wall; fewer than one may leave nothing of it.
        const float MinVoxels = 2f;
        // Fraction of a part's surface below which a thin place is but an edge or a tip, and of its thin surface that may be thinner still than
        // what is told.
        const double MinThin = 0.02, Thinnest = 0.1;
        const double MaxPartFraction = 0.9;          // of a part, from which on it is all of it: the rims of a plate are not thin
        const int MaxTold = 4;

        struct Thin
        {
            public int part;
            public double area;
            public float thickness;
            public float3 low, high;
        }

        readonly MeshParts.Part[] parts;
        readonly bool[] isFar;
        readonly FarTriangles far;
        // By triangle that takes part, those of a part together, the thinnest of each first.
        readonly float[] thickness;
        readonly int[] partOf;
        readonly float[] area;
        readonly float3[] center;

        public MeshLosses(MeshEdges edges, float[] thicknessOf, FarTriangles far)
        {
            this.far = far;
            TriangleMesh mesh = edges.Triangles.Mesh;
            parts = new MeshParts.Part[edges.Parts.Count];
            isFar = new bool[parts.Length];
            for (int part = 0; part < parts.Length; part++)
                parts[part] = edges.Parts[part];
            for (int t = 0; t < mesh.TriangleCount && far != null && !far.IsCorner; t++)
                if (far.Has(t))
                    isFar[edges.Parts.Of(t)] = true;
            int count = edges.Triangles.Count, next = 0;
            var order = new int[count];
            thickness = new float[count];
            for (int t = 0; t < mesh.TriangleCount; t++)
                if (edges.Triangles.TakesPart(t))
                    (order[next], thickness[next++]) = (t, thicknessOf[t]);
            Array.Sort(thickness, order);
            partOf = Array.ConvertAll(order, t => edges.Parts.Of(t));
            area = Array.ConvertAll(order, t => (float)math.length(edges.OutwardArea(t)));
            center = Array.ConvertAll(order, t => ((float3)mesh.Corner(t, 0) + (float3)mesh.Corner(t, 1) + (float3)mesh.Corner(t, 2)) / 3f);
        }

        public void AddFar(List<MeshLoss> losses, MeshSdfSettings settings, in MeshSdfEstimate whole, MeshReport without)
        {
            bool isLeftOut = settings.leaveOutFar;
            settings.leaveOutFar = true;
            MeshSdfEstimate rest = MeshSdfBaker.Estimate(without, settings);
            string where = far.IsCorner ? "at one corner that strayed" : "far from the rest";
            string what = Invariant($"{far.Count:N0} triangles {where}, at {Of(far.Position)} m,");
            if (isLeftOut)
            {
                losses.Add(new MeshLoss($"{what} are left out."));
                return;
            }
            string grows = settings.voxelSize > 0f
                ? Invariant($"{Of(whole.Resolution)} voxels instead of {Of(rest.Resolution)}")
                : $"voxels of {Meters(whole.VoxelSize)} instead of {Meters(rest.VoxelSize)}";
            losses.Add(new MeshLoss($"{what} make the box {Times(whole, rest)} times as long: {grows}. " +
                "Take them out of the mesh, or set Leave Out Far.", settings));
        }

        public void Add(List<MeshLoss> losses, MeshSdfSettings settings, MeshReport report)
        {
            MeshSdfEstimate estimate = MeshSdfBaker.Estimate(report, settings);
            float voxel = estimate.VoxelSize;
            bool isShell = (settings.sign == MeshSdfSign.Automatic ? report.Sign : settings.sign) == MeshSdfSign.OpenShell;
            if (!isShell)
            {
                AddThin(losses, settings, report, voxel);
                AddWithoutInside(losses, settings);
            }
            else if (settings.shellThickness > 0f && settings.shellThickness < voxel)
                losses.Add(new MeshLoss($"The shell of {Meters(settings.shellThickness)} is thinner than a voxel, {Meters(voxel)}: it may have " +
                    $"gaps. Use voxels of at most {Meters(settings.shellThickness / MinVoxels)}, or a shell thickness of 0, which is two voxels.",
                    Remedy(settings, report, settings.shellThickness)));
        }

        void AddThin(List<MeshLoss> losses, MeshSdfSettings settings, MeshReport report, float voxel)
        {
            List<Thin> found = FindThin(voxel);
            for (int i = 0; i < math.min(found.Count, MaxTold); i++)
            {
                Thin thin = found[i];
                double fraction = thin.area / parts[thin.part].area;
                string partly = fraction < MaxPartFraction ? Invariant($"on {100 * fraction:0.#} % of its surface ") : "";
                MeshSdfSettings? remedy = Remedy(settings, report, thin.thickness);
                losses.Add(new MeshLoss(
                    $"{NameOf(thin.part, parts[thin.part].Bounds.size, thin)} is {partly}thinner than a voxel, {Meters(thin.thickness)} for " +
                    $"{Meters(voxel)}: it may vanish, or leak. " + (remedy != null
                    ? $"Use voxels of at most {Meters(thin.thickness / MinVoxels)}."
                    : $"Voxels of {Meters(thin.thickness / MinVoxels)} would be too many: make it thicker, bake it by itself, or set the sign to " +
                    "open shell."), remedy));
            }
            float thinnest = float.PositiveInfinity;
            for (int i = MaxTold; i < found.Count; i++)
                thinnest = math.min(thinnest, found[i].thickness);
            if (found.Count > MaxTold)
                losses.Add(new MeshLoss(Invariant($"{found.Count - MaxTold:N0} more parts are thinner than a voxel, from {thinnest:G3} m on."),
                    Remedy(settings, report, thinnest)));
        }

        // Those with the most surface first. What is far is told of anyway.
        List<Thin> FindThin(float voxel)
        {
            int end = Array.BinarySearch(thickness, voxel);
            end = end < 0 ? ~end : end;
            var thin = new Thin[parts.Length];
            for (int part = 0; part < thin.Length; part++)
                thin[part] = new Thin { part = part, low = float.PositiveInfinity, high = float.NegativeInfinity };
            for (int i = 0; i < end; i++)
            {
                ref Thin one = ref thin[partOf[i]];
                one.area += area[i];
                one.low = math.min(one.low, center[i]);
                one.high = math.max(one.high, center[i]);
            }
            var passed = new double[parts.Length];
            for (int i = 0; i < end; i++)
            {
                double before = passed[partOf[i]], limit = Thinnest * thin[partOf[i]].area;
                passed[partOf[i]] += area[i];
                if (before <= limit && passed[partOf[i]] > limit)
                    thin[partOf[i]].thickness = thickness[i];
            }
            var found = new List<Thin>();
            foreach (Thin one in thin)
                if (one.area > MinThin * parts[one.part].area && !isFar[one.part])
                    found.Add(one);
            found.Sort((a, b) => b.area.CompareTo(a.area));
            return found;
        }

        // Beside others that have one. Where the sign was chosen, holes are to be closed.
        void AddWithoutInside(List<MeshLoss> losses, MeshSdfSettings settings)
        {
            int told = 0, more = 0;
            MeshSdfSettings shell = settings;
            shell.sign = MeshSdfSign.OpenShell;
            for (int part = 0; part < parts.Length; part++)
            {
                ref MeshParts.Part one = ref parts[part];
                double holes = one.holeArea / (one.holeArea + one.area);
                bool isOpen = holes > MeshReport.MaxHoleFraction && settings.sign == MeshSdfSign.Automatic;
                if (isFar[part] || !isOpen && (one.isOpen || MeshReport.HasVolume(one.volume, one.area)))
                    continue;
                if (told++ >= MaxTold)
                    more++;
                else
                    losses.Add(new MeshLoss($"{NameOf(part, one.Bounds.size, new Thin { low = one.low, high = one.high })} has no inside" +
                        (isOpen ? Invariant($", with {100 * holes:0.#} % of holes") : "") +
                        ": it vanishes, or is filled. Close it or make it thicker, bake it by itself, or set the sign to open shell.", shell));
            }
            if (more > 0)
                losses.Add(new MeshLoss(Invariant($"{more:N0} more parts have no inside."), shell));
        }

        static MeshSdfSettings? Remedy(MeshSdfSettings settings, MeshReport report, float thickness)
        {
            settings.voxelSize = thickness / MinVoxels;
            return settings.Validate(out _) && settings.voxelSize > 0f && MeshSdfBaker.Estimate(report, settings).Problem == null ? settings
                : (MeshSdfSettings?)null;
        }

        string NameOf(int part, float3 size, in Thin where)
            => (parts.Length == 1 ? "The mesh" : Invariant($"Part {part + 1:N0} of {parts.Length:N0}")) +
            $", {Of(size)} m large, around {Of(0.5f * (where.low + where.high))} m,";

        static string Times(in MeshSdfEstimate whole, in MeshSdfEstimate rest)
            => Invariant($"{Longest(whole.Bounds) / Longest(rest.Bounds):0.#}");

        static float Longest(Bounds bounds) => math.cmax((float3)bounds.size);
        static string Of(float3 v) => Invariant($"({v.x:G3}, {v.y:G3}, {v.z:G3})");
        static string Of(Vector3Int v) => Invariant($"{v.x} x {v.y} x {v.z}");
        static string Meters(float length) => Invariant($"{length:G3} m");
    }
}
