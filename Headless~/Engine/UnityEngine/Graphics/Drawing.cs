using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>One draw with everything that it needs, as queued, recorded or called at once.</summary>
    internal struct DrawCall
    {
        public Material Material;
        /// <summary>-1: every pass.</summary>
        public int Pass;
        public PropertyTable Block;
        public Matrix4x4 Matrix;
        public MeshTopology Topology;
        /// <summary>Null: vertices come from SV_VertexID alone.</summary>
        public Mesh Mesh;
        public int Submesh;
        public BufferStorage Indices;
        public int Count, First, Instances;
        /// <summary>Not null: counts come from here, <see cref="Commands"/> records of them.</summary>
        public BufferStorage Arguments;
        public long ArgumentsOffset;
        public int Commands;
        public Instancing Instancing;
        /// <summary>One for each instance where the instancing is by matrices; <see cref="Matrix"/> is the identity then.</summary>
        public Matrix4x4[] Matrices;
        /// <summary>For messages: the call that made this.</summary>
        public string Call;
    }

    internal static class Drawing
    {
        static readonly Func<string, float> materialFloat = name => stateMaterial.GetFloat(name);
        static Material stateMaterial;

        public static void Draw(in DrawCall call)
        {
            if (call.Material == null)
                throw new ArgumentNullException("material", $"{call.Call}: the material is null.");
            if (call.Pass >= 0)
            {
                DrawPass(call, call.Pass);
                return;
            }
            for (int pass = 0; pass < call.Material.passCount; pass++)
                DrawPass(call, pass);
        }

        public static void DrawPass(in DrawCall call, int passIndex)
        {
            Material material = call.Material;
            if (passIndex >= material.passCount)
            {
                GpuError.Report($"{call.Call}: pass {passIndex} of material '{material.name}', whose shader '{material.shader.name}' " +
                    $"has {material.passCount}.",
                    $"Trying to access pass {passIndex}, but material '{material.name}' subshader (0) has only {material.passCount} valid passes.");
                return;
            }
            DrawShaderPass(call, passIndex);
        }

        /// <summary>Draws likewise; the pass after the last included, which is the fallback's.</summary>
        internal static void DrawShaderPass(in DrawCall call, int passIndex)
        {
            if (call.Matrices != null)
                Instances.Draw(call, passIndex);
            else
                Draw(call, passIndex, 0);
        }

        /// <param name="firstInstance">Of the arrays of instanced properties.</param>
        internal static void Draw(in DrawCall call, int passIndex, int firstInstance)
        {
            Material material = call.Material;
            if (!material.Programs(passIndex, call.Instancing, out ProgramLayout vertex, out ProgramLayout fragment))
            {
                // Draws with a mesh are magenta, as in Unity.
                material = call.Mesh is object ? BuiltinResources.ErrorMaterial : null;
                passIndex = 0;
                if (material is null || !material.Programs(passIndex, Instancing.None, out vertex, out fragment))
                    return;
            }

            if (!GpuChecks.Program(vertex) || !GpuChecks.Program(fragment))
                return;
            stateMaterial = material;
            DeviceRasterState state = material.shader.PassAt(passIndex).ResolveState(materialFloat);
            if (!Topology(call, out state.Topology, out bool quads))
                return;
            // The projection flips y, but for the back buffer, which turns every triangle's winding around; a mirroring matrix turns it again.
            state.FrontIsCounterClockwise = call.Matrix.determinant >= 0 != RenderState.InvertCulling != RenderState.IsUpright;

            var draw = new DeviceDraw { VertexCount = call.Count, InstanceCount = call.Instances * RenderState.InstanceMultiplier,
                FirstVertex = call.First, Indices32 = true };
            if (!Geometry(call, vertex.Program, quads, ref draw))
                return;

            BuiltinVariables.SetObject(call.Matrix);
            DevicePass pass = DeviceObjects.Pass(vertex.Program, fragment.Program);
            int commands = call.Arguments == null ? 1 : call.Commands;
            for (int i = 0; i < commands; i++)
            {
                if (call.Arguments != null)
                {
                    draw.ArgumentsOffset = call.ArgumentsOffset + (long)i * ArgumentBytes(call);
                    BuiltinVariables.SetCommand(i);
                }
                if (!Binder.Draw(vertex, fragment, call.Block, material, firstInstance))
                    return;
                RenderState.Open();
                Gpu.DrawDevice.Draw(pass, state, Binder.Bindings, draw);
                Binder.MarkWritten();
            }
        }

        public static int ArgumentBytes(in DrawCall call) =>
            call.Indices != null || call.Mesh is object ? GraphicsBuffer.IndirectDrawIndexedArgs.size : GraphicsBuffer.IndirectDrawArgs.size;

        static bool Topology(in DrawCall call, out DeviceTopology topology, out bool quads)
        {
            quads = false;
            topology = DeviceTopology.Triangles;
            switch (call.Topology)
            {
                case MeshTopology.Triangles: return true;
                case MeshTopology.Lines: topology = DeviceTopology.Lines; return true;
                case MeshTopology.LineStrip: topology = DeviceTopology.LineStrip; return true;
                case MeshTopology.Points: topology = DeviceTopology.Points; return true;
                default:
                    quads = true;
                    if (call.Arguments == null && call.Indices == null)
                        return true;
                    throw new NotSupportedException($"{call.Call}: MeshTopology.Quads with an index buffer or indirect arguments; " +
                        $"Direct3D 11 has no quads. Use triangles.");
            }
        }

        static bool Geometry(in DrawCall call, ShaderProgram vertex, bool quads, ref DeviceDraw draw)
        {
            if (call.Mesh is object)
            {
                if (!call.Mesh.Bind(call.Submesh, vertex, ref draw))
                    return false;
            }
            else if (vertex.Inputs.Length > 0)
            {
                GpuError.Report($"{call.Call}: {vertex.Name} reads the vertex attribute '{vertex.Inputs[0].Semantic}', but a " +
                    $"procedural draw has none; use SV_VertexID.",
                    $"{call.Call}: {vertex.Name} needs vertex attributes");
                return false;
            }
            else if (quads)
            {
                draw.Indices = QuadIndices.For(call.Count / 4);
                draw.VertexCount = call.Count / 4 * 6;
            }
            else if (call.Indices != null)
            {
                BufferChecks.Alive(call.Indices, call.Call);
                if (!call.Indices.Is(GraphicsBuffer.Target.Index))
                    GpuError.Strictly($"{call.Call}: {call.Indices} is used for indices, but was created without Index among its " +
                        $"targets (it has {call.Indices.Target}).");
                BufferChecks.Readable(call.Indices, call.Call);
                draw.Indices = call.Indices.Device;
                draw.Indices32 = call.Indices.Stride == 4;
                if (call.Arguments == null && (long)call.First + call.Count > call.Indices.Count)
                    GpuError.Strictly($"{call.Call}: indices {call.First:N0} to {(long)call.First + call.Count:N0} of {call.Indices}, " +
                        $"which has {call.Indices.Count:N0}.");
            }

            if (call.Arguments != null)
            {
                if (call.Commands < 1 || !BufferChecks.Arguments(call.Arguments, call.Call, call.ArgumentsOffset,
                    call.Commands * ArgumentBytes(call)))
                    return false;
                draw.Arguments = call.Arguments.Device;
                draw.ArgumentsOffset = call.ArgumentsOffset;
                return true;
            }
            if (draw.VertexCount <= 0 || draw.InstanceCount <= 0)
            {
                if (draw.VertexCount < 0 || draw.InstanceCount < 0)
                    GpuError.Strictly($"{call.Call}: {draw.VertexCount} vertices of {draw.InstanceCount} instances; neither may be negative.");
                return false;
            }
            return true;
        }
    }
}
