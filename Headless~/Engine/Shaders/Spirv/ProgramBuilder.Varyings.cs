using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>Vulkan joins stages by number, Direct3D by semantic: here the numbers are given by semantic.</summary>
    sealed partial class ProgramBuilder
    {
        void AssignLocations(CompiledProgram result, Varying[] vertexOutputs)
        {
            var outputs = new List<Varying>();
            var inputs = new List<ShaderInput>();
            int nextInput = 0, nextOutput = 0;
            foreach (Instruction variable in module.Instructions.Where(i => i.Op == Op.Variable
                && (ClassOf(i) == StorageClass.Input || ClassOf(i) == StorageClass.Output)))
            {
                Instruction location = types.Decorated(variable[1], Decoration.Location);
                if (location == null)
                    continue;   // a system value
                Instruction semantic = types.Decorated(variable[1], Decoration.UserSemantic);
                if (semantic == null)
                    throw new ProgramException($"'{types.Name(variable[1])}' has no semantic");
                Semantic name = Semantic.Parse(semantic.Text(2));
                if (FormerSystemValue(name, variable) is uint builtIn)
                {
                    (location.Words[1], location.Words[2]) = ((uint)Decoration.BuiltIn, builtIn);
                    continue;
                }
                (int slots, int components) = Slots(types.Pointee(variable));

                if (ClassOf(variable) == StorageClass.Output && stage == ShaderStage.Vertex)
                {
                    location.Words[2] = (uint)nextOutput;
                    for (int s = 0; s < slots; s++)
                        outputs.Add(new Varying { Semantic = new Semantic(name.Name, name.Index + s).Full, Location = nextOutput + s,
                            Components = components });
                    nextOutput += slots;
                }
                else if (ClassOf(variable) == StorageClass.Output)
                    location.Words[2] = (uint)name.Index;   // SV_Target2, or COLOR2 of old
                else if (stage == ShaderStage.Vertex)
                {
                    location.Words[2] = (uint)nextInput;
                    inputs.Add(new ShaderInput { Semantic = name.Short, Location = nextInput });
                    nextInput += slots;
                }
                else
                    location.Words[2] = (uint)Match(name, components, vertexOutputs);
            }
            result.Program.Inputs = inputs.ToArray();
            result.Outputs = outputs.ToArray();
        }

        // Direct3D 9's POSITION that a vertex program writes, and VPOS that a fragment program reads, are SV_Position.
        uint? FormerSystemValue(Semantic name, Instruction variable)
        {
            const uint position = 0, fragCoord = 15;
            if (types.Pointee(variable).Op != Op.TypeVector || types.Pointee(variable)[2] != 4 || name.Index != 0)
                return null;
            if (stage == ShaderStage.Vertex && ClassOf(variable) == StorageClass.Output && name.Name == "POSITION")
                return position;
            return stage == ShaderStage.Fragment && ClassOf(variable) == StorageClass.Input && name.Name == "VPOS" ? fragCoord : (uint?)null;
        }

        static int Match(Semantic name, int components, Varying[] vertexOutputs)
        {
            Varying output = vertexOutputs?.FirstOrDefault(o => o.Semantic == name.Full);
            if (output == null)
                throw new ProgramException($"the fragment program reads {name.Short}, which the vertex program does not write");
            if (output.Components < components)
                throw new ProgramException(
                    $"the fragment program reads {components} components of {name.Short}, the vertex program writes {output.Components}");
            return output.Location;
        }

        (int slots, int components) Slots(Instruction type)
        {
            switch (type.Op)
            {
                case Op.TypeVector: return (1, (int)type[2]);
                case Op.TypeMatrix: return ((int)type[2], (int)types[type[1]][2]);
                case Op.TypeArray:
                {
                    (int slots, int components) = Slots(types[type[1]]);
                    return (slots * types.Constant(type[2]), components);
                }
                default: return (1, 1);
            }
        }
    }
}
