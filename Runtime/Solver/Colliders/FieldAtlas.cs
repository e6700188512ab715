using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Position of a field in the atlas, in fractions of the atlas.</summary>
    struct FieldBrick
    {
        /// <summary>Center of the field.</summary>
        public float3 Center;
        /// <summary>Size of a voxel.</summary>
        public float3 VoxelFraction;
        /// <summary>Offset along z to the field from which the frame's steps start; 0 where it does not deform in them.</summary>
        public float Before;
    }

    /// <summary>
    /// The fields of all colliders of one shape, distances of meshes or heights, in one texture, since a kernel cannot choose among
    /// textures: each field once, one behind the other. Half floats: a distance is off by at most 1/2048 of itself. A mesh that deforms has
    /// two in turn: of where the steps of a frame start, and of where they end.
    /// </summary>
    sealed class FieldAtlas : IDisposable
    {
        public const long BytesOfVoxel = 2;

        /// <summary>threads of CopyField along each axis</summary>
        [GenerateHlsl("FieldAtlas")] const int CopyGroup = 4;

        readonly ComputeShader shader;
        readonly Kernel copyField, blendFields;
        readonly ColliderShape shape;
        readonly string name, contents;
        readonly List<Texture3D> fields = new List<Texture3D>();
        readonly List<uint> versions = new List<uint>();
        readonly List<int> firsts = new List<int>();
        readonly List<Deforming> deforming = new List<Deforming>();
        readonly int[] brick = new int[3];
        RenderTexture texture;
        int3 size;

        // A mesh that deforms, and which of its two fields the steps of a frame end with.
        struct Deforming
        {
            public IDeformingShape shape;
            public DeformingField field;
            public int first, depth;
            public int frame;       // in which it was written last
            public bool isSecond, moves;
        }

        /// <param name="shape">Shape of the colliders whose fields it holds. An atlas is as wide and as high as the largest of them: flat fields
        /// and deep ones in one would waste most of it.</param>
        /// <param name="name">Name of the texture.</param>
        /// <param name="contents">What the fields are, for messages.</param>
        public FieldAtlas(ComputeShader shader, ColliderShape shape, string name, string contents)
        {
            this.shader = shader;
            this.shape = shape;
            this.name = name;
            this.contents = contents;
            copyField = new Kernel(shader, "CopyField");
            blendFields = new Kernel(shader, "BlendFields");
        }

        /// <summary>Why a collider of a shape cannot be held on this device; null where it can.</summary>
        public static string DeviceProblem(ColliderShape shape)
        {
            if (shape != ColliderShape.Mesh && shape != ColliderShape.HeightField || DeviceGate.HasNoGraphics)
                return null;
            string why = GpuTexture.WhyNot(RenderTextureFormat.RHalf, isWritten: true);
            return why == null ? null : $"{why}, which hold the fields of meshes and grounds. Make it of boxes, spheres and capsules there.";
        }

        /// <summary>In the units of the fields, R16; null while there is none.</summary>
        public RenderTexture Texture => texture;

        /// <summary>Makes the atlas hold the fields of its shape in a set, and only those. Copies only when one came, went or changed.</summary>
        /// <returns>Whether it did.</returns>
        /// <exception cref="ArgumentException">They are more than a texture holds; the message says what to do.</exception>
        public bool Hold(ColliderSet colliders)
        {
            if (Holds(colliders))
                return false;
            Release();
            for (int i = 0; i < colliders.Count; i++)
                if (IsFor(colliders.Items[i]))
                    Append(colliders.Items[i].field);
                else if (IsDeforming(colliders.Items[i]))
                    Append(colliders.Items[i].deforming);
            if (size.z == 0)
                return true;
            int3 needed = size;
            if (math.cmax(needed) > SystemInfo.maxTexture3DSize)
            {
                Release();
                throw new ArgumentException(Invariant($"the {contents} of the colliders need a texture of {needed.x} x {needed.y} x ") +
                    Invariant($"{needed.z}, more than the {SystemInfo.maxTexture3DSize} a side of this device. Use smaller ones, or ") +
                    "fewer that differ.");
            }
            texture = Create(name, size);
            using (var cmd = new CommandBuffer { name = "Rill.FieldAtlas" })
            {
                for (int i = 0; i < fields.Count; i++)
                    RecordCopy(cmd, fields[i], firsts[i]);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            return true;
        }

        /// <summary>Records where the meshes of the set that deform have come to, once in the steps of a frame.</summary>
        public void RecordDeforming(CommandBuffer cmd, ColliderSet colliders)
        {
            for (int i = 0; i < colliders.Count && deforming.Count > 0; i++)
            {
                ref readonly ColliderMotion collider = ref colliders.Items[i];
                if (!IsDeforming(collider))
                    continue;
                int index = IndexOf(collider.deforming);
                Deforming own = deforming[index];
                if (own.frame == colliders.Frame)
                    continue;
                bool isNew = own.frame < 0;
                own.moves = collider.deforms && !isNew;
                own.frame = colliders.Frame;
                if (own.moves)
                    own.isSecond = !own.isSecond;
                if (own.moves || isNew)
                    RecordBlend(cmd, own, collider);
                deforming[index] = own;
            }
        }

        /// <param name="collider">Collider of the set that the atlas holds.</param>
        /// <returns>Position of its field; default if it has none here.</returns>
        public FieldBrick Brick(in ColliderMotion collider)
        {
            if (IsDeforming(collider))
                return Brick(deforming[IndexOf(collider.deforming)]);
            if (!IsFor(collider))
                return default;
            float3 own = Size(collider.field);
            return new FieldBrick
            {
                Center = (0.5f * own + new float3(0f, 0f, firsts[fields.IndexOf(collider.field)])) / size,
                VoxelFraction = 1f / (float3)size,
            };
        }

        /// <summary>The texture, while there is one.</summary>
        public void Describe(StageDescription description)
        {
            if (Texture != null)
                description.Buffers.Add((name, BytesOfVoxel * size.x * size.y * size.z));
        }

        public void Dispose() => Release();

        FieldBrick Brick(in Deforming own) => new FieldBrick
        {
            Center = (0.5f * (float3)own.field.Resolution + new float3(0f, 0f, own.first + (own.isSecond ? own.depth : 0))) / size,
            VoxelFraction = 1f / (float3)size,
            Before = !own.moves ? 0f : (own.isSecond ? -own.depth : own.depth) / (float)size.z,
        };

        bool IsFor(in ColliderMotion collider) => collider.shape == shape && collider.field != null;

        bool IsDeforming(in ColliderMotion collider) => collider.shape == shape && collider.deforming?.Field != null;

        int IndexOf(IDeformingShape of)
        {
            for (int i = 0; i < deforming.Count; i++)
                if (ReferenceEquals(deforming[i].shape, of))
                    return i;
            return -1;
        }

        bool Holds(ColliderSet colliders)
        {
            int seen = 0, moving = 0;       // the first so many fields, in the order in which they were appended
            for (int i = 0; i < colliders.Count; i++)
            {
                if (IsDeforming(colliders.Items[i]))
                {
                    int at = IndexOf(colliders.Items[i].deforming);
                    if (at < 0 || at > moving || !ReferenceEquals(deforming[at].field, colliders.Items[i].deforming.Field))
                        return false;
                    moving = math.max(moving, at + 1);
                }
                if (!IsFor(colliders.Items[i]))
                    continue;
                Texture3D field = colliders.Items[i].field;
                int index = fields.IndexOf(field);
                if (index < 0 || index > seen || versions[index] != field.updateCount)
                    return false;
                seen = math.max(seen, index + 1);
            }
            return seen == fields.Count && moving == deforming.Count;
        }

        void Append(IDeformingShape moving)
        {
            if (IndexOf(moving) >= 0)
                return;
            int3 own = moving.Field.Resolution;
            deforming.Add(new Deforming { shape = moving, field = moving.Field, first = size.z, depth = own.z, frame = -1 });
            size = new int3(math.max(size.xy, own.xy), size.z + 2 * own.z);
        }

        void Append(Texture3D field)
        {
            if (fields.Contains(field))
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
            Ids.Copy.Bind(cmd, shader, copyField, field, Texture);
            SetBrick(cmd, first, own);
            int3 groups = (own + CopyGroup - 1) / CopyGroup;
            cmd.DispatchCompute(shader, copyField, groups.x, groups.y, groups.z);
        }

        void RecordBlend(CommandBuffer cmd, in Deforming own, in ColliderMotion collider)
        {
            DeformingField field = collider.deforming.Field;
            int3 resolution = field.Resolution;
            Ids.Blend.Bind(cmd, shader, blendFields, field.Older, field.Newer, collider.blend, Texture);
            SetBrick(cmd, own.first + (own.isSecond ? own.depth : 0), resolution);
            int3 groups = (resolution + CopyGroup - 1) / CopyGroup;
            cmd.DispatchCompute(shader, blendFields, groups.x, groups.y, groups.z);
        }

        // By one array: a call with three numbers makes one each time.
        void SetBrick(CommandBuffer cmd, int firstSlice, int3 resolution)
        {
            (brick[0], brick[1], brick[2]) = (0, 0, firstSlice);
            cmd.SetComputeIntParams(shader, Ids.BrickFirst, brick);
            (brick[0], brick[1], brick[2]) = (resolution.x, resolution.y, resolution.z);
            cmd.SetComputeIntParams(shader, Ids.BrickSize, brick);
        }

        static int3 Size(Texture3D field) => new int3(field.width, field.height, field.depth);

        static RenderTexture Create(string name, int3 size)
        {
            return GpuTexture.Create(name, new RenderTextureDescriptor(size.x, size.y, GraphicsFormat.R16_SFloat, GraphicsFormat.None)
            {
                dimension = TextureDimension.Tex3D, volumeDepth = size.z, enableRandomWrite = true,
            }, FilterMode.Bilinear);
        }

        void Release()
        {
            fields.Clear();
            versions.Clear();
            firsts.Clear();
            deforming.Clear();
            size = 0;
            EngineObject.Release(ref texture);
        }

        static class Ids
        {
            public static readonly ShaderParameters Copy = new ShaderParameters("_Field", "_Atlas");
            public static readonly ShaderParameters Blend = new ShaderParameters("_OlderField", "_NewerField", "_Fraction", "_Atlas");
            public static readonly int BrickFirst = Shader.PropertyToID("_BrickFirst");
            public static readonly int BrickSize = Shader.PropertyToID("_BrickSize");
        }
    }
}
