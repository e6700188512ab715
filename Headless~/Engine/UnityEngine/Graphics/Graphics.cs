using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public class Graphics
    {
        public static RenderBuffer activeColorBuffer => Active.colorBuffer;
        public static RenderBuffer activeDepthBuffer => Active.depthBuffer;
        static RenderTexture Active => RenderTexture.active != null ? RenderTexture.active : ScreenTarget.Texture;

        public static void ExecuteCommandBuffer(CommandBuffer buffer)
        {
            if (buffer == null)
                throw new ArgumentNullException(nameof(buffer));
            using NativeWork.Scope native = NativeWork.Enter();
            buffer.Execute();
        }

        public static void ExecuteCommandBufferAsync(CommandBuffer buffer, ComputeQueueType queueType) => ExecuteCommandBuffer(buffer);

        // ---- copies

        public static void CopyTexture(Texture src, Texture dst) => GraphicsCopies.Texture(src, dst);
        public static void CopyBuffer(GraphicsBuffer source, GraphicsBuffer dest)
        {
            if (source == null)
                throw new ArgumentNullException(nameof(source));
            if (dest == null)
                throw new ArgumentNullException(nameof(dest));
            GraphicsCopies.Buffer(source.Storage, dest.Storage);
        }

        public static void Blit(Texture source, RenderTexture dest) => Blitter.Blit(source, dest, null, -1);
        public static void Blit(Texture source, RenderTexture dest, Material mat) => Blit(source, dest, mat, -1);
        public static void Blit(Texture source, RenderTexture dest, Material mat, int pass)
        {
            if (mat == null)
                throw new ArgumentNullException(nameof(mat), "Graphics.Blit: the material is null.");
            Blitter.Blit(source, dest, mat, pass);
        }

        public static void Blit(Texture source, RenderTexture dest, Vector2 scale, Vector2 offset) => Blitter.Blit(source, dest, scale, offset);
        public static void Blit(Texture source, Material mat) => Blit(source, mat, -1);
        public static void Blit(Texture source, Material mat, int pass) => Blit(source, RenderTexture.active, mat, pass);

        // ---- targets

        public static void SetRenderTarget(RenderTexture rt) => RenderState.SetTarget(rt);
        public static void SetRenderTarget(RenderTexture rt, int mipLevel) => RenderState.SetTarget(rt, mipLevel);
        public static void SetRenderTarget(RenderTexture rt, int mipLevel, CubemapFace face) => RenderState.SetTarget(rt, mipLevel, (int)face);
        public static void SetRenderTarget(RenderTexture rt, int mipLevel, CubemapFace face, int depthSlice)
            => RenderState.SetTarget(rt, mipLevel, Math.Max(depthSlice, (int)face));
        public static void SetRenderTarget(RenderBuffer colorBuffer, RenderBuffer depthBuffer)
            => RenderState.SetTargets(new[] { colorBuffer.Texture }, depthBuffer.Texture, 0, 0);
        public static void SetRenderTarget(RenderBuffer[] colorBuffers, RenderBuffer depthBuffer)
            => RenderState.SetTargets(Array.ConvertAll(colorBuffers, b => b.Texture), depthBuffer.Texture, 0, 0);

        // ---- draws of this frame, for every camera that sees them

        static void Queue(in RenderParams rparams, DrawCall call, in Bounds bounds)
        {
            call.Material = rparams.material;
            call.Pass = -1;
            DrawQueue.Add(new QueuedDraw
            {
                Call = call, Bounds = bounds, HasBounds = true, Camera = rparams.camera, Layer = rparams.layer, Priority = rparams.rendererPriority,
                Shadows = rparams.shadowCastingMode, ReceivesShadows = rparams.receiveShadows, Motion = rparams.motionVectorMode,
                Reflections = rparams.reflectionProbeUsage,
            }, rparams.matProps);
        }

        static BufferStorage Arguments(GraphicsBuffer buffer, string call, int commandCount, int startCommand, int size)
        {
            if (buffer == null)
                throw new ArgumentNullException("commandBuffer", $"Graphics.{call}: the buffer of commands is null.");
            if (commandCount < 1 || startCommand < 0)
                throw new ArgumentException($"Graphics.{call}: {commandCount} commands from {startCommand}; at least one, from 0 on.");
            BufferChecks.ArgumentsPlace(buffer.Storage, call, (long)startCommand * size, commandCount * size);
            return buffer.Storage;
        }

        public static void RenderPrimitives(in RenderParams rparams, MeshTopology topology, int vertexCount, int instanceCount = 1) =>
            Queue(rparams, new DrawCall { Call = "RenderPrimitives", Matrix = Matrix4x4.identity, Topology = topology, Count = vertexCount,
            Instances = instanceCount }, rparams.worldBounds);

        public static void RenderPrimitivesIndexed(in RenderParams rparams, MeshTopology topology, GraphicsBuffer indexBuffer,
            int indexCount, int startIndex = 0, int instanceCount = 1) =>
            Queue(rparams, new DrawCall
            {
                Call = "RenderPrimitivesIndexed", Matrix = Matrix4x4.identity, Topology = topology,
                    Indices = NotNull(indexBuffer, "indexBuffer").Storage,
                Count = indexCount, First = startIndex, Instances = instanceCount,
            }, rparams.worldBounds);

        public static void RenderPrimitivesIndirect(in RenderParams rparams, MeshTopology topology, GraphicsBuffer commandBuffer,
            int commandCount = 1, int startCommand = 0) =>
            Queue(rparams, new DrawCall
            {
                Call = "RenderPrimitivesIndirect", Matrix = Matrix4x4.identity, Topology = topology,
                Arguments = Arguments(commandBuffer, "RenderPrimitivesIndirect", commandCount, startCommand, GraphicsBuffer.IndirectDrawArgs.size),
                ArgumentsOffset = (long)startCommand * GraphicsBuffer.IndirectDrawArgs.size, Commands = commandCount,
            }, rparams.worldBounds);

        public static void RenderPrimitivesIndexedIndirect(in RenderParams rparams, MeshTopology topology, GraphicsBuffer indexBuffer,
            GraphicsBuffer commandBuffer, int commandCount = 1, int startCommand = 0) =>
            Queue(rparams, new DrawCall
            {
                Call = "RenderPrimitivesIndexedIndirect", Matrix = Matrix4x4.identity, Topology = topology,
                    Indices = NotNull(indexBuffer, "indexBuffer").Storage,
                Arguments = Arguments(commandBuffer, "RenderPrimitivesIndexedIndirect", commandCount, startCommand,
                    GraphicsBuffer.IndirectDrawIndexedArgs.size),
                ArgumentsOffset = (long)startCommand * GraphicsBuffer.IndirectDrawIndexedArgs.size, Commands = commandCount,
            }, rparams.worldBounds);

        static DrawCall OfMesh(string call, Mesh mesh, int submesh, in Matrix4x4 matrix, int instances) => new DrawCall
        {
            Call = call, Mesh = NotNull(mesh, "mesh"), Submesh = submesh, Topology = mesh.GetTopology(submesh), Matrix = matrix,
                Instances = instances,
        };

        public static void RenderMesh(in RenderParams rparams, Mesh mesh, int submeshIndex, Matrix4x4 objectToWorld,
            Matrix4x4? prevObjectToWorld = null) =>
            Queue(rparams, OfMesh("RenderMesh", mesh, submeshIndex, objectToWorld, 1), Culling.Transform(mesh.bounds, objectToWorld));

        public static void RenderMeshPrimitives(in RenderParams rparams, Mesh mesh, int submeshIndex, int instanceCount = 1) =>
            Queue(rparams, Procedural(OfMesh("RenderMeshPrimitives", mesh, submeshIndex, Matrix4x4.identity, instanceCount)), rparams.worldBounds);

        public static void RenderMeshIndirect(in RenderParams rparams, Mesh mesh, GraphicsBuffer commandBuffer, int commandCount = 1,
            int startCommand = 0)
        {
            DrawCall call = OfMesh("RenderMeshIndirect", mesh, 0, Matrix4x4.identity, 1);
            call.Arguments = Arguments(commandBuffer, "RenderMeshIndirect", commandCount, startCommand, GraphicsBuffer.IndirectDrawIndexedArgs.size);
            call.ArgumentsOffset = (long)startCommand * GraphicsBuffer.IndirectDrawIndexedArgs.size;
            call.Commands = commandCount;
            call.Instancing = Instancing.Procedural;
            Queue(rparams, call, rparams.worldBounds);
        }

        public static void RenderMeshInstanced<T>(in RenderParams rparams, Mesh mesh, int submeshIndex, T[] instanceData,
            int instanceCount = -1, int startInstance = 0) where T : unmanaged =>
            Instanced(rparams, mesh, submeshIndex, NotNull(instanceData, "instanceData"), instanceCount < 0
            ? instanceData.Length - startInstance : instanceCount, startInstance);

        public static void RenderMeshInstanced<T>(in RenderParams rparams, Mesh mesh, int submeshIndex, List<T> instanceData,
            int instanceCount = -1, int startInstance = 0) where T : unmanaged =>
            RenderMeshInstanced(rparams, mesh, submeshIndex, NotNull(instanceData, "instanceData").ToArray(), instanceCount, startInstance);

        static void Instanced<T>(in RenderParams rparams, Mesh mesh, int submesh, T[] data, int count, int start) where T : unmanaged
        {
            if (!rparams.material.enableInstancing)
                throw new InvalidOperationException("Material needs to enable instancing for use with RenderMeshInstanced.");
            DrawCall call = OfInstances("RenderMeshInstanced", mesh, submesh, Instances.MatricesOf(data, start, count));
            Queue(rparams, call, InstanceBounds(mesh, call.Matrices));
        }

        static DrawCall OfInstances(string name, Mesh mesh, int submesh, Matrix4x4[] matrices)
        {
            DrawCall call = OfMesh(name, mesh, submesh, Matrix4x4.identity, matrices.Length);
            (call.Matrices, call.Instancing) = (matrices, Instancing.Matrices);
            return call;
        }

        static Bounds InstanceBounds(Mesh mesh, Matrix4x4[] matrices)
        {
            Bounds bounds = matrices.Length > 0 ? Culling.Transform(mesh.bounds, matrices[0]) : default;
            foreach (Matrix4x4 matrix in matrices)
                bounds.Encapsulate(Culling.Transform(mesh.bounds, matrix));
            return bounds;
        }

        static T NotNull<T>(T value, string parameter) where T : class => value ?? throw new ArgumentNullException(parameter);

        // ---- the older names of the same

        static void Queue(Material material, DrawCall call, in Bounds bounds, Camera camera, MaterialPropertyBlock properties, int layer,
            ShadowCastingMode castShadows, bool receiveShadows)
        {
            call.Material = material;
            call.Pass = -1;
            DrawQueue.Add(new QueuedDraw { Call = call, Bounds = bounds, HasBounds = true, Camera = camera, Layer = layer,
                Shadows = castShadows, ReceivesShadows = receiveShadows }, properties);
        }

        public static void DrawProcedural(Material material, Bounds bounds, MeshTopology topology, int vertexCount, int instanceCount = 1,
            Camera camera = null, MaterialPropertyBlock properties = null, ShadowCastingMode castShadows = ShadowCastingMode.On,
            bool receiveShadows = true, int layer = 0) =>
            Queue(material, new DrawCall { Call = "DrawProcedural", Matrix = Matrix4x4.identity, Topology = topology, Count = vertexCount,
            Instances = instanceCount }, bounds, camera, properties, layer, castShadows, receiveShadows);

        public static void DrawProcedural(Material material, Bounds bounds, MeshTopology topology, GraphicsBuffer indexBuffer,
            int indexCount, int instanceCount = 1, Camera camera = null, MaterialPropertyBlock properties = null,
            ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
            Queue(material, new DrawCall { Call = "DrawProcedural", Matrix = Matrix4x4.identity, Topology = topology,
            Indices = NotNull(indexBuffer, "indexBuffer").Storage, Count = indexCount, Instances = instanceCount }, bounds, camera,
            properties, layer, castShadows, receiveShadows);

        static DrawCall Indirect(string name, MeshTopology topology, BufferStorage indices, BufferStorage arguments, int offset) => new DrawCall
        {
            Call = name, Matrix = Matrix4x4.identity, Topology = topology, Indices = indices,
                Arguments = NotNull(arguments, "bufferWithArgs"), ArgumentsOffset = offset, Commands = 1,
        };

        public static void DrawProceduralIndirect(Material material, Bounds bounds, MeshTopology topology, ComputeBuffer bufferWithArgs,
            int argsOffset = 0, Camera camera = null, MaterialPropertyBlock properties = null,
            ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
            Queue(material, Indirect("DrawProceduralIndirect", topology, null, bufferWithArgs?.Storage, argsOffset), bounds, camera,
            properties, layer, castShadows, receiveShadows);

        public static void DrawProceduralIndirect(Material material, Bounds bounds, MeshTopology topology, GraphicsBuffer indexBuffer,
            ComputeBuffer bufferWithArgs, int argsOffset = 0, Camera camera = null, MaterialPropertyBlock properties = null,
            ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
            Queue(material, Indirect("DrawProceduralIndirect", topology, NotNull(indexBuffer, "indexBuffer").Storage,
            bufferWithArgs?.Storage, argsOffset), bounds, camera, properties, layer, castShadows, receiveShadows);

        public static void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, Bounds bounds,
            ComputeBuffer bufferWithArgs, int argsOffset = 0, MaterialPropertyBlock properties = null,
            ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0, Camera camera = null,
            LightProbeUsage lightProbeUsage = LightProbeUsage.BlendProbes) =>
            MeshIndirect(mesh, submeshIndex, material, bounds, bufferWithArgs?.Storage, argsOffset, properties, layer, camera, castShadows,
            receiveShadows);

        public static void DrawProceduralIndirectNow(MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset = 0)
            => Now(Indirect("DrawProceduralIndirectNow", topology, null, bufferWithArgs?.Storage, argsOffset));
        public static void DrawProceduralIndirectNow(MeshTopology topology, GraphicsBuffer indexBuffer, ComputeBuffer bufferWithArgs,
            int argsOffset = 0) => Now(Indirect("DrawProceduralIndirectNow", topology, NotNull(indexBuffer, "indexBuffer").Storage,
            bufferWithArgs?.Storage, argsOffset));

        public static void DrawProceduralIndirect(Material material, Bounds bounds, MeshTopology topology, GraphicsBuffer bufferWithArgs,
            int argsOffset = 0, Camera camera = null, MaterialPropertyBlock properties = null,
            ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
            Queue(material, Indirect("DrawProceduralIndirect", topology, null, bufferWithArgs?.Storage, argsOffset), bounds, camera,
            properties, layer, castShadows, receiveShadows);

        public static void DrawProceduralIndirect(Material material, Bounds bounds, MeshTopology topology, GraphicsBuffer indexBuffer,
            GraphicsBuffer bufferWithArgs, int argsOffset = 0, Camera camera = null, MaterialPropertyBlock properties = null,
            ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0) =>
            Queue(material, Indirect("DrawProceduralIndirect", topology, NotNull(indexBuffer, "indexBuffer").Storage,
            bufferWithArgs?.Storage, argsOffset), bounds, camera, properties, layer, castShadows, receiveShadows);

        public static void DrawMeshInstancedIndirect(Mesh mesh, int submeshIndex, Material material, Bounds bounds,
            GraphicsBuffer bufferWithArgs, int argsOffset = 0, MaterialPropertyBlock properties = null,
            ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true, int layer = 0, Camera camera = null,
            LightProbeUsage lightProbeUsage = LightProbeUsage.BlendProbes) =>
            MeshIndirect(mesh, submeshIndex, material, bounds, bufferWithArgs?.Storage, argsOffset, properties, layer, camera, castShadows,
            receiveShadows);

        public static void DrawProceduralIndirectNow(MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset = 0)
            => Now(Indirect("DrawProceduralIndirectNow", topology, null, bufferWithArgs?.Storage, argsOffset));
        public static void DrawProceduralIndirectNow(MeshTopology topology, GraphicsBuffer indexBuffer, GraphicsBuffer bufferWithArgs,
            int argsOffset = 0) => Now(Indirect("DrawProceduralIndirectNow", topology, NotNull(indexBuffer, "indexBuffer").Storage,
            bufferWithArgs?.Storage, argsOffset));

        static void MeshIndirect(Mesh mesh, int submesh, Material material, in Bounds bounds, BufferStorage arguments, int offset,
            MaterialPropertyBlock properties, int layer, Camera camera, ShadowCastingMode castShadows, bool receiveShadows)
        {
            DrawCall call = OfMesh("DrawMeshInstancedIndirect", mesh, submesh, Matrix4x4.identity, 1);
            call.Arguments = NotNull(arguments, "bufferWithArgs");
            call.ArgumentsOffset = offset;
            call.Commands = 1;
            call.Instancing = Instancing.Procedural;
            Queue(material, call, bounds, camera, properties, layer, castShadows, receiveShadows);
        }

        public static void DrawMeshInstancedProcedural(Mesh mesh, int submeshIndex, Material material, Bounds bounds, int count,
            MaterialPropertyBlock properties = null, ShadowCastingMode castShadows = ShadowCastingMode.On, bool receiveShadows = true,
            int layer = 0, Camera camera = null, LightProbeUsage lightProbeUsage = LightProbeUsage.BlendProbes,
            LightProbeProxyVolume lightProbeProxyVolume = null) =>
            Queue(material, Procedural(OfMesh("DrawMeshInstancedProcedural", mesh, submeshIndex, Matrix4x4.identity, count)), bounds,
            camera, properties, layer, castShadows, receiveShadows);

        static DrawCall Procedural(DrawCall call)
        {
            call.Instancing = Instancing.Procedural;
            return call;
        }

        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer) => DrawMesh(mesh, matrix, material, layer, null);
        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera)
            => DrawMesh(mesh, matrix, material, layer, camera, 0);
        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera, int submeshIndex)
            => DrawMesh(mesh, matrix, material, layer, camera, submeshIndex, null);
        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera, int submeshIndex,
            MaterialPropertyBlock properties) => DrawMesh(mesh, matrix, material, layer, camera, submeshIndex, properties,
            ShadowCastingMode.On);
        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera, int submeshIndex,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows) => DrawMesh(mesh, matrix, material, layer, camera,
            submeshIndex, properties, castShadows, true);
        public static void DrawMesh(Mesh mesh, Matrix4x4 matrix, Material material, int layer, Camera camera, int submeshIndex,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows) =>
            Queue(material, OfMesh("DrawMesh", mesh, submeshIndex, matrix, 1), Culling.Transform(mesh.bounds, matrix), camera, properties,
            layer, castShadows, receiveShadows);

        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer)
            => DrawMesh(mesh, position, rotation, material, layer, null);
        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer, Camera camera)
            => DrawMesh(mesh, position, rotation, material, layer, camera, 0);
        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer, Camera camera,
            int submeshIndex) => DrawMesh(mesh, position, rotation, material, layer, camera, submeshIndex, null);
        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer, Camera camera,
            int submeshIndex, MaterialPropertyBlock properties) => DrawMesh(mesh, position, rotation, material, layer, camera, submeshIndex,
            properties, ShadowCastingMode.On);
        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer, Camera camera,
            int submeshIndex, MaterialPropertyBlock properties, ShadowCastingMode castShadows) => DrawMesh(mesh, position, rotation,
            material, layer, camera, submeshIndex, properties, castShadows, true);
        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Material material, int layer, Camera camera,
            int submeshIndex, MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows) =>
            DrawMesh(mesh, Matrix4x4.TRS(position, rotation, Vector3.one), material, layer, camera, submeshIndex, properties, castShadows,
            receiveShadows);

        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices, int count)
            => DrawMeshInstanced(mesh, submeshIndex, material, matrices, count, null);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices, int count,
            MaterialPropertyBlock properties) => DrawMeshInstanced(mesh, submeshIndex, material, matrices, count, properties,
            ShadowCastingMode.On);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices, int count,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows) => DrawMeshInstanced(mesh, submeshIndex, material, matrices,
            count, properties, castShadows, true);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices, int count,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows) => DrawMeshInstanced(mesh, submeshIndex,
            material, matrices, count, properties, castShadows, receiveShadows, 0);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices, int count,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows, int layer) => DrawMeshInstanced(mesh,
            submeshIndex, material, matrices, count, properties, castShadows, receiveShadows, layer, null);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices, int count,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows, int layer, Camera camera) =>
            QueueInstances(mesh, submeshIndex, material, matrices, count, properties, layer, camera, castShadows, receiveShadows);

        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, Matrix4x4[] matrices)
            => DrawMeshInstanced(mesh, submeshIndex, material, matrices, matrices.Length);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, List<Matrix4x4> matrices)
            => DrawMeshInstanced(mesh, submeshIndex, material, matrices.ToArray());

        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, List<Matrix4x4> matrices,
            MaterialPropertyBlock properties) => DrawMeshInstanced(mesh, submeshIndex, material, matrices.ToArray(), matrices.Count,
            properties);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, List<Matrix4x4> matrices,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows) => DrawMeshInstanced(mesh, submeshIndex, material,
            matrices.ToArray(), matrices.Count, properties, castShadows);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, List<Matrix4x4> matrices,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows) => DrawMeshInstanced(mesh, submeshIndex,
            material, matrices.ToArray(), matrices.Count, properties, castShadows, receiveShadows);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, List<Matrix4x4> matrices,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows, int layer) => DrawMeshInstanced(mesh,
            submeshIndex, material, matrices.ToArray(), matrices.Count, properties, castShadows, receiveShadows, layer);
        public static void DrawMeshInstanced(Mesh mesh, int submeshIndex, Material material, List<Matrix4x4> matrices,
            MaterialPropertyBlock properties, ShadowCastingMode castShadows, bool receiveShadows, int layer,
            Camera camera) => DrawMeshInstanced(mesh, submeshIndex, material, matrices.ToArray(), matrices.Count, properties, castShadows,
            receiveShadows, layer, camera);

        static void QueueInstances(Mesh mesh, int submesh, Material material, Matrix4x4[] matrices, int count,
            MaterialPropertyBlock properties, int layer, Camera camera, ShadowCastingMode castShadows, bool receiveShadows)
        {
            if (count < 0 || count > Math.Min(1023, matrices.Length))
                throw new ArgumentOutOfRangeException(nameof(count), count,
                    $"DrawMeshInstanced takes 0 to {Math.Min(1023, matrices.Length)} of these matrices.");
            if (!material.enableInstancing)
                throw new InvalidOperationException("Material needs to enable instancing for use with DrawMeshInstanced.");
            DrawCall call = OfInstances("DrawMeshInstanced", mesh, submesh, matrices.AsSpan(0, count).ToArray());
            Queue(material, call, InstanceBounds(mesh, call.Matrices), camera, properties, layer, castShadows, receiveShadows);
        }

        // ---- draws at once, into the active target, with the pass of Material.SetPass

        static void Now(DrawCall call)
        {
            if (RenderState.CurrentMaterial == null)
            {
                GpuError.Report($"Graphics.{call.Call}: call Material.SetPass first.", $"Graphics.{call.Call}: no material pass is set");
                return;
            }
            call.Material = RenderState.CurrentMaterial;
            call.Pass = RenderState.CurrentPass;
            Drawing.Draw(call);
        }

        public static void DrawProceduralNow(MeshTopology topology, int vertexCount, int instanceCount = 1) =>
            Now(new DrawCall { Call = "DrawProceduralNow", Matrix = Matrix4x4.identity, Topology = topology, Count = vertexCount,
            Instances = instanceCount });
        public static void DrawProceduralNow(MeshTopology topology, GraphicsBuffer indexBuffer, int indexCount, int instanceCount = 1) =>
            Now(new DrawCall { Call = "DrawProceduralNow", Matrix = Matrix4x4.identity, Topology = topology,
            Indices = NotNull(indexBuffer, "indexBuffer").Storage, Count = indexCount, Instances = instanceCount });
        public static void DrawMeshNow(Mesh mesh, Matrix4x4 matrix) => DrawMeshNow(mesh, matrix, 0);
        public static void DrawMeshNow(Mesh mesh, Matrix4x4 matrix, int materialIndex) => Now(OfMesh("DrawMeshNow", mesh, materialIndex, matrix, 1));
        public static void DrawMeshNow(Mesh mesh, Vector3 position, Quaternion rotation)
            => DrawMeshNow(mesh, Matrix4x4.TRS(position, rotation, Vector3.one), 0);
    }
}
