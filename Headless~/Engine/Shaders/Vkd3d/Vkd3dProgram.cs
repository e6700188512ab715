using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Text.RegularExpressions;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>
    /// Turns vkd3d's module into one that binds as <see cref="ProgramBuilder"/>'s do. The module names its resources by
    /// their registers (t0, u1, u1_counter, cb0_0, s0); what lies behind these the bytecode's RDEF chunk says.
    /// </summary>
    sealed partial class Vkd3dProgram
    {
        const int FirstFragmentBinding = 32;
        static readonly Regex RegisterName = new Regex(@"^(?:(cb)(\d+)_\d+|([tus])(\d+)(_counter)?)$");

        readonly DxbcContainer container;
        readonly ResourceDefinitions definitions;
        readonly SpirvModule module;
        readonly SpirvTypes types;
        readonly SpirvEditor editor;
        readonly ShaderStage stage;
        readonly List<Instruction> output = new List<Instruction>();

        Vkd3dProgram(byte[] dxbc, byte[] spirv, ShaderStage stage)
        {
            container = new DxbcContainer(dxbc);
            definitions = new ResourceDefinitions(container);
            module = SpirvModule.Read(spirv);
            types = new SpirvTypes(module);
            editor = new SpirvEditor(module);
            this.stage = stage;
        }

        /// <param name="dxbc">What FXC emitted.</param>
        /// <param name="spirv">What vkd3d made of it, with buffers as texel buffers.</param>
        /// <param name="vertexOutputs">Fragment programs: what the vertex program of the same pass writes.</param>
        /// <exception cref="ProgramException"/>
        public static CompiledProgram Build(byte[] dxbc, byte[] spirv, string name, ShaderStage stage, SourceDeclarations declarations,
            Varying[] vertexOutputs)
        {
            var builder = new Vkd3dProgram(dxbc, spirv, stage);
            var program = new ShaderProgram { Name = name, Stage = stage,
                EntryPoint = builder.module.Instructions.First(i => i.Op == Op.EntryPoint).Text(2) };
            var result = new CompiledProgram { Program = program };
            program.Resources = builder.BindResources(declarations);
            program.UavCount = program.Resources.Count(r => r.IsUnorderedAccess());
            if (stage == ShaderStage.Compute)
                builder.DescribeGroup(program);
            else
                builder.Link(result, vertexOutputs);
            builder.Rewrite();
            if (stage == ShaderStage.Vertex)
                builder.AllowLayers();
            DirectXArithmetic.Apply(builder.module);
            program.Spirv = builder.module.Write();
            return result;
        }

        // ---- resources

        ShaderResource[] BindResources(SourceDeclarations declarations)
        {
            var variables = new Dictionary<string, Instruction>();
            foreach (Instruction variable in module.Instructions.Where(i => i.Op == Op.Variable && IsResource(i)))
                variables.Add(RegisterOf(types.Name(variable[1])), variable);

            var resources = new List<ShaderResource>();
            int binding = stage == ShaderStage.Fragment ? FirstFragmentBinding : 0;
            void Bind(ShaderResource resource, string register)
            {
                // A register that no instruction touches has no variable.
                if (!variables.Remove(register, out Instruction variable))
                    return;
                resource.Binding = binding++;
                editor.Decorate(variable[1], Decoration.DescriptorSet, 0);
                editor.Decorate(variable[1], Decoration.Binding, (uint)resource.Binding);
                resources.Add(resource);
                if (resource.Kind is ShaderResourceKind.StructuredBuffer or ShaderResourceKind.RawBuffer or ShaderResourceKind.RWStructuredBuffer or ShaderResourceKind.RWRawBuffer or ShaderResourceKind.Counter)
                    MakeStorageBuffer(variable, readOnly: resource.Kind is ShaderResourceKind.StructuredBuffer or ShaderResourceKind.RawBuffer);
            }

            foreach (BoundResource bound in definitions.Resources)
            {
                ShaderResource resource = DefinedResource.Describe(bound, definitions, declarations);
                string register = RegisterOf(bound);
                Bind(resource, register);
                if (resource.Kind == ShaderResourceKind.RWStructuredBuffer)
                    Bind(new ShaderResource { Name = bound.Name, Kind = ShaderResourceKind.Counter, Stride = 4 }, register + "_counter");
            }
            if (variables.Count > 0)
                throw new ProgramException(
                    $"vkd3d binds {string.Join(", ", variables.Keys)}, which the bytecode's resource definitions do not name.");
            return resources.ToArray();
        }

        static bool IsResource(Instruction variable)
            => (StorageClass)variable[2] is StorageClass.UniformConstant or StorageClass.Uniform or StorageClass.StorageBuffer;

        static string RegisterOf(string variable)
        {
            Match match = RegisterName.Match(variable);
            if (!match.Success)
                throw new ProgramException($"vkd3d calls a resource '{variable}', which is not a register.");
            return match.Groups[1].Value + match.Groups[2].Value + match.Groups[3].Value + match.Groups[4].Value + match.Groups[5].Value;
        }

        static string RegisterOf(BoundResource bound)
        {
            switch (bound.Type)
            {
                case ShaderInputType.ConstantBuffer: return "cb" + bound.Register;
                case ShaderInputType.Sampler: return "s" + bound.Register;
                case ShaderInputType.TextureBuffer:
                case ShaderInputType.Texture:
                case ShaderInputType.Structured:
                case ShaderInputType.ByteAddress: return "t" + bound.Register;
                default: return "u" + bound.Register;
            }
        }

        void DescribeGroup(ShaderProgram program)
        {
            var declared = new DxbcDeclarations(container);
            (program.GroupX, program.GroupY, program.GroupZ) = declared.GroupSize;
            program.GroupsharedBytes = declared.GroupsharedBytes;
        }

        // ---- stages

        // Both numbers a varying by its register, as Direct3D joins stages; it demands that the semantics agree there.
        void Link(CompiledProgram result, Varying[] vertexOutputs)
        {
            if (stage == ShaderStage.Vertex)
            {
                var locations = new HashSet<int>(module.Instructions.Where(i => i.Op == Op.Variable && (StorageClass)i[2] == StorageClass.Input)
                    .Select(i => types.Decorated(i[1], Decoration.Location)).Where(location => location != null)
                        .Select(location => (int)location[2]));
                result.Program.Inputs = Signature.Inputs(container).Where(e => e.SystemValue == 0 && locations.Contains(e.Register))
                    .Select(e => new ShaderInput { Semantic = e.Semantic.Short, Location = e.Register }).ToArray();
                result.Outputs = Signature.Outputs(container).Where(e => e.SystemValue == 0).Select(e => new Varying
                {
                    Semantic = e.Semantic.Full,
                    Location = e.Register,
                    First = BitOperations.TrailingZeroCount(e.Mask),
                    Components = BitOperations.PopCount((uint)e.Mask),
                }).ToArray();
                return;
            }
            foreach (SignatureElement input in Signature.Inputs(container).Where(e => e.SystemValue == 0 && e.ReadMask != 0))
            {
                Varying written = vertexOutputs.FirstOrDefault(o => o.Semantic == input.Semantic.Full);
                if (written == null)
                    throw new ProgramException($"the fragment program reads {input.Semantic.Short}, which the vertex program does not write");
                int components = BitOperations.Log2((uint)input.ReadMask) + 1 - BitOperations.TrailingZeroCount(input.Mask);
                if (written.Components < components)
                    throw new ProgramException($"the fragment program reads {components} components of {input.Semantic.Short}, the " +
                        $"vertex program writes {written.Components}");
                if (written.Location != input.Register || written.First != BitOperations.TrailingZeroCount(input.Mask))
                    throw new ProgramException($"the fragment program reads {input.Semantic.Short} from another register than the " +
                        $"vertex program writes it to; Direct3D joins stages by register: declare the same struct, or the same order, in both");
            }
        }
    }
}
