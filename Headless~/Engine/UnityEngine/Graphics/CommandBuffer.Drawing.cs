using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;

namespace UnityEngine.Rendering
{
    public partial class CommandBuffer
    {
        // ---- targets

        public void SetRenderTarget(RenderTargetIdentifier rt) => Target(rt, 0, 0);
        public void SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction loadAction, RenderBufferStoreAction storeAction)
            => Target(rt, 0, 0);
        public void SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction colorLoadAction,
            RenderBufferStoreAction colorStoreAction, RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction depthStoreAction) =>
            Target(rt, 0, 0);
        public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel) => Target(rt, mipLevel, 0);
        public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace)
            => Target(rt, mipLevel, Math.Max(0, (int)cubemapFace));
        public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace, int depthSlice)
            => Target(rt, mipLevel, Math.Max(depthSlice, (int)cubemapFace));
        public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth) => Targets(new[] { color }, depth, 0, 0);
        public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel)
            => Targets(new[] { color }, depth, mipLevel, 0);
        public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel, CubemapFace cubemapFace)
            => Targets(new[] { color }, depth, mipLevel, Math.Max(0, (int)cubemapFace));
        public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel, CubemapFace cubemapFace,
            int depthSlice) => Targets(new[] { color }, depth, mipLevel, Math.Max(depthSlice, (int)cubemapFace));
        public void SetRenderTarget(RenderTargetIdentifier color, RenderBufferLoadAction colorLoadAction,
            RenderBufferStoreAction colorStoreAction, RenderTargetIdentifier depth, RenderBufferLoadAction depthLoadAction,
            RenderBufferStoreAction depthStoreAction) => Targets(new[] { color }, depth, 0, 0);
        public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth) => Targets(colors, depth, 0, 0);
        public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth, int mipLevel, CubemapFace cubemapFace,
            int depthSlice) => Targets(colors, depth, mipLevel, Math.Max(depthSlice, (int)cubemapFace));
        public void SetRenderTarget(RenderTargetBinding binding) => Targets(binding.colorRenderTargets, binding.depthRenderTarget, 0, 0);
        public void SetRenderTarget(RenderTargetBinding binding, int mipLevel, CubemapFace cubemapFace, int depthSlice)
            => Targets(binding.colorRenderTargets, binding.depthRenderTarget, mipLevel, Math.Max(depthSlice, (int)cubemapFace));

        void Target(in RenderTargetIdentifier rt, int mip, int slice)
        {
            int target = AddTarget(rt);
            ref Command c = ref Add(Op.SetTarget);
            (c.A, c.B, c.C) = (target, mip, slice);
        }

        void Targets(RenderTargetIdentifier[] colors, in RenderTargetIdentifier depth, int mip, int slice)
        {
            int first = targets.Count;
            targets.AddRange(NotNull(colors, "colors", "SetRenderTarget"));
            targets.Add(depth);
            ref Command c = ref Add(Op.SetTargets);
            (c.A, c.B, c.C, c.D) = (first, colors.Length, mip, slice);
        }

        void SetTarget(in Command c) => RenderState.SetTarget(AsTarget(targets[c.A].Resolve()), c.B != 0 ? c.B : targets[c.A].Mip, c.C != 0
            ? c.C : targets[c.A].DepthSlice);

        void SetTargets(in Command c)
        {
            var colors = new RenderTexture[c.B];
            for (int i = 0; i < colors.Length; i++)
                colors[i] = AsTarget(targets[c.A + i].Resolve());
            RenderState.SetTargets(colors, AsTarget(targets[c.A + c.B].Resolve()), c.C, c.D);
        }

        static RenderTexture AsTarget(Texture texture)
        {
            if (texture is null || texture is RenderTexture)
                return (RenderTexture)texture;
            throw new GpuUsageException($"SetRenderTarget: {texture.GetType().Name} '{texture.name}' is no RenderTexture.");
        }

        public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor)
            => ClearRenderTarget(clearDepth, clearColor, backgroundColor, 1);
        public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor, float depth)
        {
            ref Command c = ref Add(Op.Clear);
            (c.A, c.B) = ((clearDepth ? 1 : 0) | (clearColor ? 2 : 0), BitConverter.SingleToInt32Bits(depth));
            Store(ref c, (Vector4)backgroundColor);
        }

        public void SetViewport(Rect pixelRect) => Store(ref Add(Op.Viewport), pixelRect);
        public void SetViewMatrix(Matrix4x4 view) => Store(ref Add(Op.View), view);
        public void SetProjectionMatrix(Matrix4x4 proj) => Store(ref Add(Op.Projection), proj);
        public void SetViewProjectionMatrices(Matrix4x4 view, Matrix4x4 proj) => Store(ref Add(Op.ViewProjection), new[] { view, proj });
        public void SetInvertCulling(bool invertCulling) => Add(Op.InvertCulling).Flag = invertCulling;

        public void GetTemporaryRT(int nameID, RenderTextureDescriptor desc) => GetTemporaryRT(nameID, desc, FilterMode.Point);
        public void GetTemporaryRT(int nameID, RenderTextureDescriptor desc, FilterMode filter)
        {
            ref Command c = ref Add(Op.TemporaryTarget);
            (c.A, c.B, c.Object) = (nameID, (int)filter, desc);
        }

        // Sizes of -1, -2 ... mean the camera's, halved ... when the command executes.
        public void GetTemporaryRT(int nameID, int width, int height) => GetTemporaryRT(nameID, width, height, 0);
        public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer)
            => GetTemporaryRT(nameID, width, height, depthBuffer, FilterMode.Point);
        public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer, FilterMode filter)
            => GetTemporaryRT(nameID, width, height, depthBuffer, filter, RenderTextureFormat.Default);
        public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer, FilterMode filter, RenderTextureFormat format)
            => GetTemporaryRT(nameID, width, height, depthBuffer, filter, format, RenderTextureReadWrite.Default);
        public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer, FilterMode filter, RenderTextureFormat format,
            RenderTextureReadWrite readWrite) =>
            GetTemporaryRT(nameID, new RenderTextureDescriptor(width, height, format, depthBuffer, 1,
            readWrite == RenderTextureReadWrite.Linear ? readWrite : RenderTextureReadWrite.sRGB), filter);
        public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer, FilterMode filter, GraphicsFormat format)
            => GetTemporaryRT(nameID, new RenderTextureDescriptor(width, height, format, depthBuffer), filter);
        public void ReleaseTemporaryRT(int nameID) => Add(Op.ReleaseTemporary).A = nameID;

        public void CopyTexture(RenderTargetIdentifier src, RenderTargetIdentifier dst)
        {
            int from = AddTarget(src), to = AddTarget(dst);
            ref Command c = ref Add(Op.CopyTexture);
            (c.A, c.B) = (from, to);
        }

        void CopyTexture(in Command c)
        {
            Texture source = targets[c.A].Resolve();
            if (targets[c.A].Type == BuiltinRenderTextureType.CameraTarget && ReferenceEquals(source, ScreenTarget.Texture))
            {
                GpuError.Report("CopyTexture from CameraTarget: this camera draws straight to the screen, which is not a texture; use Blit.",
                    "CommandBuffer: CopyTexture can not copy from the back buffer");
                return;
            }
            GraphicsCopies.Texture(source, targets[c.B].Resolve());
        }

        // ---- blits

        public void Blit(Texture source, RenderTargetIdentifier dest) => Blit(source, dest, null, -1);
        public void Blit(Texture source, RenderTargetIdentifier dest, Material mat) => Blit(source, dest, mat, -1);
        public void Blit(Texture source, RenderTargetIdentifier dest, Material mat, int pass)
            => Blit(new RenderTargetIdentifier(source), dest, mat, pass);
        public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest) => Blit(source, dest, null, -1);
        public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest, Material mat) => Blit(source, dest, mat, -1);

        public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest, Material mat, int pass)
        {
            int from = AddTarget(source), to = AddTarget(dest);
            ref Command c = ref Add(Op.Blit);
            (c.A, c.B, c.C, c.Object) = (from, to, pass, mat);
        }

        public void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest, int sourceDepthSlice, int destDepthSlice)
        {
            int from = AddTarget(source), to = AddTarget(dest);
            ref Command c = ref Add(Op.BlitSlice);
            (c.A, c.B, c.C, c.D) = (from, to, sourceDepthSlice, destDepthSlice);
        }

        void Blit(in Command c) => Blitter.Blit(targets[c.A].Resolve(), AsTarget(targets[c.B].Resolve()), (Material)c.Object, c.C);
        void BlitSlice(in Command c) => Blitter.BlitSlice(targets[c.A].Resolve(), AsTarget(targets[c.B].Resolve()), c.C, c.D);

        // ---- draws

        void Draw(DrawCall call, MaterialPropertyBlock properties)
        {
            if (call.Material == null)
                throw new ArgumentNullException("material", $"CommandBuffer.{call.Call}: the material is null.");
            if (properties != null && !properties.isEmpty)
            {
                call.Block = new PropertyTable();
                call.Block.CopyFrom(properties.Values);
            }
            draws.Add(call);
            Add(Op.Draw).A = draws.Count - 1;
        }

        public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount)
            => DrawProcedural(matrix, material, shaderPass, topology, vertexCount, 1);
        public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount,
            int instanceCount) => DrawProcedural(matrix, material, shaderPass, topology, vertexCount, instanceCount, null);
        public void DrawProcedural(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology, int vertexCount,
            int instanceCount, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawProcedural", Matrix = matrix, Material = material, Pass = shaderPass, Topology = topology,
            Count = vertexCount, Instances = instanceCount }, properties);

        public void DrawProcedural(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            int indexCount) => DrawProcedural(indexBuffer, matrix, material, shaderPass, topology, indexCount, 1);
        public void DrawProcedural(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            int indexCount, int instanceCount) => DrawProcedural(indexBuffer, matrix, material, shaderPass, topology, indexCount,
            instanceCount, null);
        public void DrawProcedural(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            int indexCount, int instanceCount, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawProcedural", Indices = NotNull(indexBuffer, "indexBuffer", "DrawProcedural").Storage,
            Matrix = matrix, Material = material, Pass = shaderPass, Topology = topology, Count = indexCount, Instances = instanceCount },
            properties);

        public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            ComputeBuffer bufferWithArgs) => DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, 0);
        public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            ComputeBuffer bufferWithArgs, int argsOffset) => DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs,
            argsOffset, null);
        public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            ComputeBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawProceduralIndirect", Matrix = matrix, Material = material, Pass = shaderPass,
            Topology = topology, Arguments = NotNull(bufferWithArgs, "bufferWithArgs", "DrawProceduralIndirect").Storage,
            ArgumentsOffset = argsOffset, Commands = 1 }, properties);

        public void DrawProceduralIndirect(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass,
            MeshTopology topology, ComputeBuffer bufferWithArgs) => DrawProceduralIndirect(indexBuffer, matrix, material, shaderPass,
            topology, bufferWithArgs, 0);
        public void DrawProceduralIndirect(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass,
            MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset) => DrawProceduralIndirect(indexBuffer, matrix, material,
            shaderPass, topology, bufferWithArgs, argsOffset, null);
        public void DrawProceduralIndirect(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass,
            MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawProceduralIndirect",
            Indices = NotNull(indexBuffer, "indexBuffer", "DrawProceduralIndirect").Storage, Matrix = matrix, Material = material,
            Pass = shaderPass, Topology = topology, Arguments = NotNull(bufferWithArgs, "bufferWithArgs", "DrawProceduralIndirect").Storage,
            ArgumentsOffset = argsOffset, Commands = 1 }, properties);

        public void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, int shaderPass, ComputeBuffer bufferWithArgs)
            => DrawMeshInstancedIndirect(mesh, submeshIndex, material, shaderPass, bufferWithArgs, 0);
        public void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, int shaderPass, ComputeBuffer bufferWithArgs,
            int argsOffset) => DrawMeshInstancedIndirect(mesh, submeshIndex, material, shaderPass, bufferWithArgs, argsOffset, null);
        public void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, int shaderPass, ComputeBuffer bufferWithArgs,
            int argsOffset, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawMeshInstancedIndirect", Instancing = Instancing.Procedural,
            Mesh = NotNull(mesh, "mesh", "DrawMeshInstancedIndirect"), Submesh = submeshIndex, Matrix = Matrix4x4.identity,
            Material = material, Pass = shaderPass, Topology = mesh.GetTopology(submeshIndex),
            Arguments = NotNull(bufferWithArgs, "bufferWithArgs", "DrawMeshInstancedIndirect").Storage, ArgumentsOffset = argsOffset,
            Commands = 1 }, properties);

        public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            GraphicsBuffer bufferWithArgs) => DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs, 0);
        public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            GraphicsBuffer bufferWithArgs, int argsOffset) => DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs,
            argsOffset, null);
        public void DrawProceduralIndirect(Matrix4x4 matrix, Material material, int shaderPass, MeshTopology topology,
            GraphicsBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawProceduralIndirect", Matrix = matrix, Material = material, Pass = shaderPass,
            Topology = topology, Arguments = NotNull(bufferWithArgs, "bufferWithArgs", "DrawProceduralIndirect").Storage,
            ArgumentsOffset = argsOffset, Commands = 1 }, properties);

        public void DrawProceduralIndirect(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass,
            MeshTopology topology, GraphicsBuffer bufferWithArgs) => DrawProceduralIndirect(indexBuffer, matrix, material, shaderPass,
            topology, bufferWithArgs, 0);
        public void DrawProceduralIndirect(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass,
            MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset) => DrawProceduralIndirect(indexBuffer, matrix, material,
            shaderPass, topology, bufferWithArgs, argsOffset, null);
        public void DrawProceduralIndirect(GraphicsBuffer indexBuffer, Matrix4x4 matrix, Material material, int shaderPass,
            MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawProceduralIndirect",
            Indices = NotNull(indexBuffer, "indexBuffer", "DrawProceduralIndirect").Storage, Matrix = matrix, Material = material,
            Pass = shaderPass, Topology = topology, Arguments = NotNull(bufferWithArgs, "bufferWithArgs", "DrawProceduralIndirect").Storage,
            ArgumentsOffset = argsOffset, Commands = 1 }, properties);

        public void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, int shaderPass, GraphicsBuffer bufferWithArgs)
            => DrawMeshInstancedIndirect(mesh, submeshIndex, material, shaderPass, bufferWithArgs, 0);
        public void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, int shaderPass, GraphicsBuffer bufferWithArgs,
            int argsOffset) => DrawMeshInstancedIndirect(mesh, submeshIndex, material, shaderPass, bufferWithArgs, argsOffset, null);
        public void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, int shaderPass, GraphicsBuffer bufferWithArgs,
            int argsOffset, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawMeshInstancedIndirect", Instancing = Instancing.Procedural,
            Mesh = NotNull(mesh, "mesh", "DrawMeshInstancedIndirect"), Submesh = submeshIndex, Matrix = Matrix4x4.identity,
            Material = material, Pass = shaderPass, Topology = mesh.GetTopology(submeshIndex),
            Arguments = NotNull(bufferWithArgs, "bufferWithArgs", "DrawMeshInstancedIndirect").Storage, ArgumentsOffset = argsOffset,
            Commands = 1 }, properties);

        public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material) => DrawMesh(mesh, matrix, material, 0);
        public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex) => DrawMesh(mesh, matrix, material, submeshIndex, -1);
        public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex, int shaderPass)
            => DrawMesh(mesh, matrix, material, submeshIndex, shaderPass, null);
        public void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int submeshIndex, int shaderPass, MaterialPropertyBlock properties) =>
            Draw(new DrawCall { Call = "DrawMesh", Mesh = NotNull(mesh, "mesh", "DrawMesh"), Submesh = submeshIndex, Matrix = matrix,
            Material = material, Pass = shaderPass, Topology = mesh.GetTopology(submeshIndex), Instances = 1 }, properties);

        public void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, int shaderPass, Matrix4x4[] matrices)
            => DrawMeshInstanced(mesh, submeshIndex, material, shaderPass, matrices,
            NotNull(matrices, "matrices", "DrawMeshInstanced").Length);
        public void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, int shaderPass, Matrix4x4[] matrices, int count)
            => DrawMeshInstanced(mesh, submeshIndex, material, shaderPass, matrices, count, null);
        public void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, int shaderPass, Matrix4x4[] matrices, int count,
            MaterialPropertyBlock properties)
        {
            if (!NotNull(material, "material", "DrawMeshInstanced").enableInstancing)
                throw new InvalidOperationException("Material needs to enable instancing for use with DrawMeshInstanced.");
            if (count < 0 || count > Math.Min(1023, matrices.Length))
                throw new ArgumentOutOfRangeException(nameof(count), count,
                    $"DrawMeshInstanced takes 0 to {Math.Min(1023, matrices.Length)} of these matrices.");
            Draw(new DrawCall { Call = "DrawMeshInstanced", Mesh = NotNull(mesh, "mesh", "DrawMeshInstanced"), Submesh = submeshIndex,
                Matrix = Matrix4x4.identity, Matrices = matrices.AsSpan(0, count).ToArray(), Instancing = Instancing.Matrices,
                Instances = count, Material = material, Pass = shaderPass, Topology = mesh.GetTopology(submeshIndex) }, properties);
        }

        public void DrawMeshInstancedProcedural(Mesh mesh, int submeshIndex, Material material, int shaderPass, int count,
            MaterialPropertyBlock properties = null) =>
            Draw(new DrawCall { Call = "DrawMeshInstancedProcedural", Instancing = Instancing.Procedural,
            Mesh = NotNull(mesh, "mesh", "DrawMeshInstancedProcedural"), Submesh = submeshIndex, Matrix = Matrix4x4.identity,
            Material = material, Pass = shaderPass, Topology = mesh.GetTopology(submeshIndex), Instances = count }, properties);

        public void DrawRenderer(Renderer renderer, Material material) => DrawRenderer(renderer, material, 0);
        public void DrawRenderer(Renderer renderer, Material material, int submeshIndex) => DrawRenderer(renderer, material, submeshIndex, -1);
        public void DrawRenderer(Renderer renderer, Material material, int submeshIndex, int shaderPass) =>
            DrawMesh(NotNull(renderer, "renderer", "DrawRenderer").MeshToDraw, renderer.localToWorldMatrix, material, submeshIndex, shaderPass);
    }
}
