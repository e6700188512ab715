using System;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Distance to the surface of a mesh at the centers of a grid of voxels, m, negative inside, in the frame of the mesh.
    /// Made by <see cref="MeshSdfBaker"/>; a bake again replaces the content and keeps the asset, so that references stay.
    /// </summary>
    [Icon(PackagePaths.Icon), ManualPage("baking", "signed-distance-field")]
    public sealed class SignedDistanceField : ScriptableObject, ISerializationCallbackReceiver
    {
        /// <summary>Version of the serialized content. An older asset is brought up to it as it loads; a newer one is refused.</summary>
        public const int CurrentVersion = 1;

        // No initial value: a file without the field keeps it, and is to be told from one of this version.
        [SerializeField, HideInInspector] int version;
        [SerializeField] Texture3D texture;
        [SerializeField] Bounds bounds;
        [SerializeField] float voxelSize;
        [SerializeField] MeshSdfSign sign = MeshSdfSign.WindingNumber;
        [SerializeField] float shellThickness;
        [SerializeField] float storageError;
        [SerializeField] string sourceMesh = "";
        [SerializeField] long sourceMeshId;
        [SerializeField] ulong sourceHash;
        [SerializeField] MeshSdfSettings settings = MeshSdfSettings.Default;

        [NonSerialized] float volume;
        [NonSerialized] bool volumeIsKnown;
        [NonSerialized] SurfaceSample[] patches;

        /// <summary>Version of the serialized content; above <see cref="CurrentVersion"/> in an asset of a newer package.</summary>
        public int Version => version;

        /// <summary>One channel, R16 or R32 float: distances, m. Its texel (x, y, z) is the voxel of that index. Null before the first
        /// bake.</summary>
        public Texture3D Texture => texture;

        /// <summary>The volume that the voxels fill, m: the center of voxel i is at min + (i + 0.5) <see cref="VoxelSize"/>.</summary>
        public Bounds Bounds => bounds;

        /// <summary>Edge of a voxel, which is a cube, m.</summary>
        public float VoxelSize => voxelSize;

        /// <summary>Voxels along each axis.</summary>
        public Vector3Int Resolution => texture != null ? new Vector3Int(texture.width, texture.height, texture.depth) : Vector3Int.zero;

        /// <summary>How inside was told from outside.</summary>
        public MeshSdfSign Sign => sign;

        /// <summary>Thickness of the shell that an open surface became, m; 0 for a solid.</summary>
        public float ShellThickness => shellThickness;

        /// <summary>Largest error of any voxel that the texture's format made, m, measured at the bake.</summary>
        public float StorageError => storageError;

        /// <summary>GUID of the mesh's asset as Unity writes it, 32 hexadecimal digits; empty where the mesh was none.</summary>
        public string SourceMesh => sourceMesh;

        /// <summary>Identifier of the mesh among the objects of its asset, as Unity's local file identifiers are; 0 where it is unknown.</summary>
        public long SourceMeshId => sourceMeshId;

        /// <summary><see cref="TriangleMesh.Hash"/> of the mesh as it was baked; 0 where it is unknown.</summary>
        public ulong SourceHash => sourceHash;

        /// <summary>Whether the mesh has changed since it was baked, or is another one. False where the field does not know what it was
        /// baked from.</summary>
        public bool IsStale(TriangleMesh mesh) => sourceHash != 0 && sourceHash != mesh.Hash();

        /// <summary>Settings it was baked with, for baking it again.</summary>
        public MeshSdfSettings Settings => settings;

        /// <summary>An asset in memory with the content of a bake. The caller saves or destroys it, and its texture with it.</summary>
        public static SignedDistanceField Create(SdfBake bake, string sourceMesh = "", long sourceMeshId = 0)
        {
            var field = CreateInstance<SignedDistanceField>();
            field.name = bake.Name;
            field.Apply(bake, sourceMesh, sourceMeshId);
            return field;
        }

        /// <summary>Replaces the content by that of a bake. The object stays, and the texture too where size and format do.</summary>
        /// <param name="sourceMesh">GUID of the mesh's asset; empty if it has none.</param>
        /// <param name="sourceMeshId">Local file identifier of the mesh in that asset.</param>
        /// <returns>The texture that was replaced, which the caller destroys and, in the editor, takes out of the asset's file; null if it
        /// stayed.</returns>
        public Texture3D Apply(SdfBake bake, string sourceMesh = "", long sourceMeshId = 0)
        {
            if (bake == null)
                throw new ArgumentNullException(nameof(bake));

            string textureName = bake.Name + " Distances";
            Texture3D replaced = bake.Format == SdfFormat.Half ? Fill(textureName, bake.Resolution, TextureFormat.RHalf, bake.ToHalf())
                : Fill(textureName, bake.Resolution, TextureFormat.RFloat, bake.Distances);
            version = CurrentVersion;
            bounds = bake.Bounds;
            voxelSize = bake.VoxelSize;
            sign = bake.Sign;
            shellThickness = bake.ShellThickness;
            storageError = bake.StorageError;
            settings = bake.Settings;
            this.sourceMesh = sourceMesh ?? "";
            this.sourceMeshId = sourceMeshId;
            sourceHash = bake.SourceHash;
            return replaced;
        }

        /// <summary>Replaces the distances alone.</summary>
        /// <param name="voxels">As the format has them, x fastest.</param>
        /// <returns>As <see cref="Apply"/>.</returns>
        internal Texture3D Fill<T>(string textureName, Vector3Int resolution, TextureFormat format, T[] voxels) where T : struct
        {
            Texture3D replaced = null;
            bool fits = texture != null && texture.isReadable && texture.format == format && texture.mipmapCount == 1 && Resolution == resolution;
            if (!fits)
            {
                replaced = texture;
                texture = new Texture3D(resolution.x, resolution.y, resolution.z, format, false)
                {
                    name = textureName,
                    wrapMode = TextureWrapMode.Clamp,
                    filterMode = FilterMode.Bilinear,
                };
            }
            texture.SetPixelData(voxels, 0);
            // Stays readable: without its copy in memory the texture could not be saved, nor sampled by TrySample.
            texture.Apply(false, false);
            volumeIsKnown = false;
            patches = null;
            return replaced;
        }

        /// <summary>Leaves it without distances, which <see cref="Validate"/> then says. The caller destroys the texture.</summary>
        internal void Empty()
        {
            texture = null;
            volumeIsKnown = false;
            patches = null;
        }

        /// <summary>Distance at a point, m, trilinear between the voxels' centers. Outside of the bounds: the distance to them, plus the
        /// value where they are nearest.</summary>
        /// <param name="local">In the frame of the mesh, m.</param>
        /// <returns>False without a texture that can be read, or for a point that is not finite; the distance is then +infinity.</returns>
        public bool TrySample(float3 local, out float distance)
        {
            distance = float.PositiveInfinity;
            return TryGetSampler(out FieldSampler sampler) && sampler.TrySample(local, out distance);
        }

        /// <summary>For many samples: looks the texture up once.</summary>
        /// <returns>False without a texture that can be read.</returns>
        internal bool TryGetSampler(out FieldSampler sampler)
        {
            bool isThere = texture != null && texture.isReadable && voxelSize > 0f;
            sampler = isThere ? new FieldSampler(texture, bounds, voxelSize) : default;
            return isThere;
        }

        /// <summary>Volume inside of the surface, m³: summed over all voxels at the first call after a bake. 0 without a texture that
        /// can be read.</summary>
        public float Volume
        {
            get
            {
                if (!volumeIsKnown && texture != null && texture.isReadable)
                {
                    volume = MeasureVolume();
                    volumeIsKnown = true;
                }
                return volume;
            }
        }

        /// <summary>See <see cref="FieldSurface"/>: found at the first call after a bake.</summary>
        internal SurfaceSample[] SurfacePatches => patches ??= FieldSurface.Find(texture, bounds, voxelSize);

        // Sums, for each voxel, the fraction that a flat surface at its distance leaves inside.
        float MeasureVolume()
        {
            var voxels = new FieldVoxels(texture);
            double sum = 0.0;
            for (int z = 0; z < texture.depth; z++)
                for (int y = 0; y < texture.height; y++)
                    for (int x = 0; x < texture.width; x++)
                        sum += math.saturate(0.5f - voxels[x, y, z] / voxelSize);
            return (float)(sum * voxelSize * voxelSize * voxelSize);
        }

        /// <summary>Whether the content can be used.</summary>
        /// <param name="problem">What is wrong and what to do; null if nothing is.</param>
        public bool Validate(out string problem)
        {
            problem = null;
            if (version > CurrentVersion)
                problem = Invariant($"'{name}' has version {version}, but this package reads up to {CurrentVersion}: update the ") +
                    "package, or bake it again.";
            else if (texture == null)
                problem = $"'{name}' has no distances: bake a mesh into it.";
            else if (texture.format != TextureFormat.RHalf && texture.format != TextureFormat.RFloat)
                problem = Invariant($"'{name}' has a texture of {texture.format}, not of one float a voxel: bake it again.");
            else if (!(voxelSize > 0f) || float.IsInfinity(voxelSize) || !Fits())
                problem = Invariant($"'{name}' has bounds of {bounds.size} m, which its {Resolution} voxels of {voxelSize} m do not ") +
                    "fill: bake it again.";
            return problem == null;
        }

        bool Fits()
        {
            float3 filled = voxelSize * new float3(texture.width, texture.height, texture.depth);
            return math.all(math.isfinite((float3)bounds.center)) && math.all(math.abs((float3)bounds.size - filled) < 0.01f * voxelSize);
        }

        /// <summary>Brings the content of an older version up to this one.</summary>
        void Migrate()
        {
            // Version 0 is what stood in files before the field was: it told no storage error, which is unknown, not 0.
            if (version < 1)
                storageError = float.NaN;
            version = Math.Max(version, CurrentVersion);
        }

        void ISerializationCallbackReceiver.OnBeforeSerialize() { }

        void ISerializationCallbackReceiver.OnAfterDeserialize()
        {
            volumeIsKnown = false;
            Migrate();
        }
    }
}
