using System;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public sealed partial class Mesh
    {
        public void RecalculateTangents() => RecalculateTangents(MeshUpdateFlags.Default);

        /// <summary>Along growing u, perpendicular to the normal; w turns the cross product of both towards growing v.</summary>
        public void RecalculateTangents(MeshUpdateFlags flags)
        {
            Vector4[] uv = uvData[0];
            if (uv == null || uv.Length != positions.Length || normalData.Length != positions.Length)
                return;
            var along = new Vector3[positions.Length];
            var across = new Vector3[positions.Length];
            int[] corners = AllIndices();
            for (int t = 0; t + 2 < corners.Length; t += 3)
            {
                int a = corners[t], b = corners[t + 1], c = corners[t + 2];
                Vector3 p = positions[b] - positions[a], q = positions[c] - positions[a];
                float pu = uv[b].x - uv[a].x, pv = uv[b].y - uv[a].y, qu = uv[c].x - uv[a].x, qv = uv[c].y - uv[a].y;
                float area = pu * qv - qu * pv;
                if (Math.Abs(area) < 1e-12f)
                    continue;
                Vector3 u = (p * qv - q * pv) / area, v = (q * pu - p * qu) / area;
                foreach (int corner in new[] { a, b, c })
                {
                    along[corner] += u;
                    across[corner] += v;
                }
            }
            var made = new Vector4[positions.Length];
            for (int i = 0; i < made.Length; i++)
            {
                Vector3 n = normalData[i], t = (along[i] - n * Vector3.Dot(n, along[i])).normalized;
                if (t == Vector3.zero)
                    t = Vector3.Cross(n, Math.Abs(n.y) < 0.9f ? Vector3.up : Vector3.right).normalized;
                made[i] = new Vector4(t.x, t.y, t.z, Vector3.Dot(Vector3.Cross(n, t), across[i]) < 0 ? -1 : 1);
            }
            tangents = made;
        }
    }
}
