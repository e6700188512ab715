using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Where a field lies in the atlas, in shares of it.</summary>
    struct FieldBrick
    {
        /// <summary>Of the middle of the field.</summary>
        public float3 Center;
        /// <summary>Of a voxel.</summary>
        public float3 VoxelShare;
    }

    /// <summary>
    /// The signed distances of all mesh colliders, and the heights of height fields, in one texture, since a kernel cannot choose among textures: each field
    /// once, one above the other. Half floats: a distance is off by at most 1/2048 of itself.
    /// </summary>
    sealed class FieldAtlas : IDisposable
    {
        const int CopyGroup = 4;            // threads of CopyField along an axis

        readonly ComputeShader shader;
        readonly int copyField;
        readonly List<Texture3D> fields = new List<Texture3D>();
        readonly List<uint> versions = new List<uint>();
        readonly List<int> firsts = new List<int>();
        int3 size = 1;

        public FieldAtlas(ComputeShader shader)
        {
            this.shader = shader;
            copyField = shader.FindKernel("CopyField");
            Texture = Create(1);
        }

        /// <summary>Distances in the units of their fields, R16; 1 x 1 x 1 while there is no mesh.</summary>
        public RenderTexture Texture { get; private set; }

        /// <summary>Makes the atlas hold the fields of a set, and only those. Copies only when one came, went or changed.</summary>
        /// <returns>Whether it did.</returns>
        /// <exception cref="ArgumentException">They are more than a texture holds; the message says what to do.</exception>
        public bool Hold(ColliderSet colliders)
        {
            if (Holds(colliders))
                return false;
            fields.Clear();
            versions.Clear();
            firsts.Clear();
            size = 0;
            for (int i = 0; i < colliders.Count; i++)
                Append(colliders.Items[i].field);
            size = math.max(size, 1);
            if (math.cmax(size) > SystemInfo.maxTexture3DSize)
                throw new ArgumentException($"the signed distance fields and height fields of the colliders need a texture of {size.x} x {size.y} x {size.z} voxels, more than the {SystemInfo.maxTexture3DSize} a side of this device. Give them fewer voxels or heights, or use fewer different ones.");
            Release();
            Texture = Create(size);
            using (var cmd = new CommandBuffer { name = "Rill.FieldAtlas" })
            {
                for (int i = 0; i < fields.Count; i++)
                    RecordCopy(cmd, fields[i], firsts[i]);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            return true;
        }

        /// <param name="field">One that the atlas holds.</param>
        public FieldBrick Brick(Texture3D field)
        {
            float3 own = Size(field);
            return new FieldBrick
            {
                Center = (0.5f * own + new float3(0f, 0f, firsts[fields.IndexOf(field)])) / size,
                VoxelShare = 1f / (float3)size,
            };
        }

        public long Bytes => 2L * size.x * size.y * size.z;

        public void Dispose() => Release();

        bool Holds(ColliderSet colliders)
        {
            int different = 0;
            for (int i = 0; i < colliders.Count; i++)
            {
                Texture3D field = colliders.Items[i].field;
                if (field == null)
                    continue;
                int index = fields.IndexOf(field);
                if (index < 0 || versions[index] != field.updateCount)
                    return false;
                different = math.max(different, index + 1);
            }
            return different == fields.Count;
        }

        void Append(Texture3D field)
        {
            if (field == null || fields.Contains(field))
                return;
            fields.Add(field);
            versions.Add(field.updateCount);
            firsts.Add(size.z);
            int3 own = Size(field);
            size = new int3(math.max(size.xy, own.xy), size.z + own.z);
        }

        void RecordCopy(CommandBuffer cmd, Texture3D field, int first)
        {
            int3 own = Size(field);
            cmd.SetComputeTextureParam(shader, copyField, Ids.Field, field);
            cmd.SetComputeTextureParam(shader, copyField, Ids.Atlas, Texture);
            cmd.SetComputeIntParams(shader, Ids.BrickFirst, 0, 0, first);
            cmd.SetComputeIntParams(shader, Ids.BrickSize, own.x, own.y, own.z);
            int3 groups = (own + CopyGroup - 1) / CopyGroup;
            cmd.DispatchCompute(shader, copyField, groups.x, groups.y, groups.z);
        }

        static int3 Size(Texture3D field) => new int3(field.width, field.height, field.depth);

        static RenderTexture Create(int3 size)
        {
            var texture = new RenderTexture(size.x, size.y, GraphicsFormat.R16_SFloat, GraphicsFormat.None)
            {
                name = "Rill.Colliders.Fields",
                dimension = TextureDimension.Tex3D,
                volumeDepth = size.z,
                enableRandomWrite = true,
                filterMode = FilterMode.Bilinear,
                wrapMode = TextureWrapMode.Clamp,
                hideFlags = HideFlags.HideAndDontSave,
            };
            texture.Create();
            return texture;
        }

        void Release()
        {
            if (Texture == null)
                return;
            Texture.Release();
            if (Application.isPlaying)
                UnityEngine.Object.Destroy(Texture);
            else
                UnityEngine.Object.DestroyImmediate(Texture);
            Texture = null;
        }

        static class Ids
        {
            public static readonly int Field = Shader.PropertyToID("_Field");
            public static readonly int Atlas = Shader.PropertyToID("_Atlas");
            public static readonly int BrickFirst = Shader.PropertyToID("_BrickFirst");
            public static readonly int BrickSize = Shader.PropertyToID("_BrickSize");
        }
    }
}
