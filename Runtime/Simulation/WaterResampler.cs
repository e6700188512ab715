using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>The particles of a fluid at another spacing: as many as its volume holds, where the old ones were densest, with their
    /// velocities.</summary>
    /// <remarks>
    /// New particles lie on a cubic lattice. Its sites are ranked by the density of the old particles there, and the best are taken: so the volume
    /// is kept to a particle, whatever the surface. What is thinner than the new spacing becomes a part of the rest.
    /// </remarks>
    sealed class WaterResampler
    {
        const float MinDensity = 0.1f;          // of rest: sites below it are in the air
        const float Jitter = 0.02f;             // new spacings: a perfect lattice keeps balances that do not last
        const int Ranks = 1 << 16;
        const float MaxDensity = 2f;

        readonly float4[] positions;            // of the old, in new spacings
        readonly float4[] velocities;
        readonly uint[] tags;                   // null for none
        readonly ColliderSet colliders;
        readonly float ratio, support, whole;
        readonly float3 size, origin, step;      // of the lattice
        int3 cells, low;
        int[] cellStarts, order;

        /// <param name="positions">xyz, old spacings, in the domain's frame; those that are not finite are left out.</param>
        /// <param name="velocities">xyz, old spacings a second.</param>
        /// <param name="tags">As many, or none.</param>
        /// <param name="ratio">Old spacing over new.</param>
        /// <param name="size">Size of the domain, new spacings.</param>
        /// <param name="colliders">In old spacings: no new particle touches one.</param>
        /// <param name="down">Along gravity in the domain's frame: the lattice lies on that side.</param>
        public WaterResampler(ReadOnlySpan<float4> positions, ReadOnlySpan<float4> velocities, ReadOnlySpan<uint> tags, float ratio, float3 size,
            float3 down, ColliderSet colliders)
        {
            this.colliders = colliders;
            this.ratio = ratio;
            this.size = size;
            support = math.max(2f * ratio, ratio + 1f);
            whole = 64f * math.PI / 315f * math.pow(support / ratio, 3f);
            this.positions = new float4[positions.Length];
            this.velocities = new float4[positions.Length];
            this.tags = tags.Length == positions.Length && tags.Length > 0 ? new uint[tags.Length] : null;
            for (int i = 0; i < positions.Length; i++)
            {
                if (!math.all(math.isfinite(positions[i].xyz)) || !math.all(math.isfinite(velocities[i].xyz)))
                    continue;
                this.positions[Count] = new float4(math.clamp(positions[i].xyz * ratio, 0f, size), 0f);
                this.velocities[Count] = new float4(velocities[i].xyz * ratio, 0f);
                if (this.tags != null)
                    this.tags[Count] = tags[i];
                Count++;
            }
            // Across gravity whole layers from wall to wall, a little closer or wider, and along it wider or closer by as much, so that a site
            // stands for a cube of the new spacing.
            int along = math.abs(down.x) > 0.7f ? 0 : math.abs(down.z) > 0.7f ? 2 : 1;
            step = size / math.max(math.round(size), 1f);
            step[along] = 1f / (step[(along + 1) % 3] * step[(along + 2) % 3]);
            origin = 0.5f * step;
            if (down[along] > 0f)
                origin[along] = size[along] - (math.floor(size[along] / step[along] - 0.5f + 1e-3f) + 0.5f) * step[along];
        }

        /// <summary>Old particles.</summary>
        public int Count { get; private set; }

        /// <summary>New particles that their volume holds.</summary>
        public long Wanted => (long)math.round(Count * (double)ratio * ratio * ratio);

        /// <summary>Finds the new particles; velocities in new spacings a second.</summary>
        public void Resample(out float4[] to, out float4[] toVelocities, out uint[] toTags)
        {
            Sort();
            int3[] chosen = Choose((int)Wanted);
            to = new float4[chosen.Length];
            toVelocities = new float4[chosen.Length];
            toTags = tags != null ? new uint[chosen.Length] : null;
            double3 sum = 0.0, before = 0.0;
            for (int i = 0; i < chosen.Length; i++)
            {
                float3 p = origin + step * chosen[i];
                Mean(p, out float3 velocity, out int nearest);
                var random = new Unity.Mathematics.Random(Hash(chosen[i]) | 1u);
                to[i] = new float4(p + Jitter * random.NextFloat3(-1f, 1f), 0f);
                toVelocities[i] = new float4(velocity, 0f);
                sum += velocity;
                if (toTags != null)
                    toTags[i] = tags[nearest];
            }
            for (int i = 0; i < Count; i++)
                before += velocities[i].xyz;
            if (chosen.Length == 0)
                return;
            // The momentum to rounding: what the means have lost of it is little, and shared by all.
            var lost = (float3)(before / Count - sum / chosen.Length);
            for (int i = 0; i < chosen.Length; i++)
                toVelocities[i].xyz += lost;
        }

        /// <summary>The old particles as they are.</summary>
        public void Copy(out float4[] to, out float4[] toVelocities, out uint[] toTags)
        {
            to = positions.AsSpan(0, Count).ToArray();
            toVelocities = velocities.AsSpan(0, Count).ToArray();
            toTags = tags?.AsSpan(0, Count).ToArray();
        }

        // Returns the sites with the highest density; among equal ones a hash decides.
        int3[] Choose(int count)
        {
            var sites = new List<int3>();
            var ranks = new List<int>();
            var histogram = new int[Ranks];
            int3 last = (int3)math.floor((size - 0.5f * step - origin) / step + 1e-3f);
            for (int cell = 0; cell < cellStarts.Length - 1; cell++)
            {
                int3 at = At(cell);
                if (!HasNear(at))
                    continue;
                // The sites of the new lattice in this cell.
                int3 from = math.max((int3)math.ceil(((float3)(at + low) * support - origin) / step), 0);
                int3 to = math.min((int3)math.ceil(((float3)(at + low + 1) * support - origin) / step) - 1, last);
                for (int z = from.z; z <= to.z; z++)
                    for (int y = from.y; y <= to.y; y++)
                        for (int x = from.x; x <= to.x; x++)
                        {
                            var site = new int3(x, y, z);
                            float density = Density(origin + step * site);
                            if (density < MinDensity || Touches(origin + step * site))
                                continue;
                            int rank = math.min((int)(density / MaxDensity * Ranks), Ranks - 1);
                            sites.Add(site);
                            ranks.Add(rank);
                            histogram[rank]++;
                        }
            }
            int least = Ranks - 1, above = 0;
            while (least > 0 && above + histogram[least] < count)
                above += histogram[least--];
            // Among those with the last rank, the first by their hashes are taken.
            var ties = new List<(uint hash, int index)>();
            var chosen = new List<int3>(count);
            for (int i = 0; i < sites.Count; i++)
                if (ranks[i] > least)
                    chosen.Add(sites[i]);
                else if (ranks[i] == least)
                    ties.Add((Hash(sites[i]), i));
            ties.Sort();
            for (int i = 0; i < ties.Count && chosen.Count < count; i++)
                chosen.Add(sites[ties[i].index]);
            return chosen.ToArray();
        }

        bool Touches(float3 p)
        {
            for (int i = 0; i < colliders.Count; i++)
                if (ratio * ColliderDistance.At(colliders.Items[i], p / ratio) < Colliders.ContactOffset)
                    return true;
            return false;
        }

        // Relative to rest, as if the domain's walls were water.
        float Density(float3 p)
        {
            float sum = 0f;
            int3 at = CellOf(p);
            for (int z = math.max(at.z - 1, 0); z <= math.min(at.z + 1, cells.z - 1); z++)
                for (int y = math.max(at.y - 1, 0); y <= math.min(at.y + 1, cells.y - 1); y++)
                    for (int x = math.max(at.x - 1, 0); x <= math.min(at.x + 1, cells.x - 1); x++)
                    {
                        int cell = Index(new int3(x, y, z));
                        for (int i = cellStarts[cell]; i < cellStarts[cell + 1]; i++)
                            sum += Kernel(p, order[i]);
                    }
            float3 open = Within(p / support) + Within((size - p) / support) - 1f;
            return sum / (whole * math.max(open.x * open.y * open.z, 0.05f));
        }

        void Mean(float3 p, out float3 velocity, out int nearest)
        {
            float sum = 0f, most = -1f;
            velocity = 0f;
            nearest = 0;
            int3 at = CellOf(p);
            for (int z = math.max(at.z - 1, 0); z <= math.min(at.z + 1, cells.z - 1); z++)
                for (int y = math.max(at.y - 1, 0); y <= math.min(at.y + 1, cells.y - 1); y++)
                    for (int x = math.max(at.x - 1, 0); x <= math.min(at.x + 1, cells.x - 1); x++)
                    {
                        int cell = Index(new int3(x, y, z));
                        for (int i = cellStarts[cell]; i < cellStarts[cell + 1]; i++)
                        {
                            float weight = Kernel(p, order[i]);
                            sum += weight;
                            velocity += weight * velocities[order[i]].xyz;
                            if (weight <= most)
                                continue;
                            most = weight;
                            nearest = order[i];
                        }
                    }
            velocity = sum > 0f ? velocity / sum : 0f;
        }

        float Kernel(float3 p, int of)
        {
            float left = 1f - math.distancesq(p, positions[of].xyz) / (support * support);
            return left > 0f ? left * left * left : 0f;
        }

        // Fraction of the kernel on this side of a plane at a distance of s supports.
        static float3 Within(float3 s)
        {
            s = math.min(s, 1f);
            float3 square = s * s;
            return 0.5f + 0.5f / 0.406349f * s * (1f - square * (4f / 3f - square * (1.2f - square * (4f / 7f - square / 9f))));
        }

        void Sort()
        {
            float3 from = float.MaxValue, to = float.MinValue;
            for (int i = 0; i < Count; i++)
            {
                from = math.min(from, positions[i].xyz);
                to = math.max(to, positions[i].xyz);
            }
            if (Count == 0)
                from = to = 0f;
            low = (int3)math.floor(from / support) - 1;
            cells = (int3)math.floor(to / support) + 2 - low;
            cellStarts = new int[cells.x * cells.y * cells.z + 1];
            for (int i = 0; i < Count; i++)
                cellStarts[Index(CellOf(positions[i].xyz)) + 1]++;
            for (int cell = 1; cell < cellStarts.Length; cell++)
                cellStarts[cell] += cellStarts[cell - 1];
            var next = (int[])cellStarts.Clone();
            order = new int[Count];
            for (int i = 0; i < Count; i++)
                order[next[Index(CellOf(positions[i].xyz))]++] = i;
        }

        bool HasNear(int3 at)
        {
            for (int z = math.max(at.z - 1, 0); z <= math.min(at.z + 1, cells.z - 1); z++)
                for (int y = math.max(at.y - 1, 0); y <= math.min(at.y + 1, cells.y - 1); y++)
                {
                    int first = Index(new int3(math.max(at.x - 1, 0), y, z)), end = Index(new int3(math.min(at.x + 1, cells.x - 1), y, z)) + 1;
                    if (cellStarts[end] > cellStarts[first])
                        return true;
                }
            return false;
        }

        int3 CellOf(float3 p) => math.clamp((int3)math.floor(p / support) - low, 0, cells - 1);

        int Index(int3 cell) => (cell.z * cells.y + cell.y) * cells.x + cell.x;

        int3 At(int index) => new int3(index % cells.x, index / cells.x % cells.y, index / (cells.x * cells.y));

        static uint Hash(int3 site) => math.hash(site);
    }
}
