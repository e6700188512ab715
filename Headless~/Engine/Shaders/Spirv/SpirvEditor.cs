using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>
    /// For a pass over a finished module: types of values, and types and constants by what they are, made where the module
    /// lacks them.
    /// </summary>
    sealed class SpirvEditor
    {
        readonly SpirvModule module;
        readonly Dictionary<uint, Instruction> definitions = new Dictionary<uint, Instruction>();
        readonly List<Instruction> globals = new List<Instruction>();
        readonly List<Instruction> decorations = new List<Instruction>();

        public SpirvEditor(SpirvModule module)
        {
            this.module = module;
            // Instructions with a result are defined before their uses, so the operands of those without come too late.
            foreach (Instruction i in module.Instructions.SkipWhile(i => !IsType(i)))
                if (IsType(i))
                    definitions[i[0]] = i;
                else if (i.Words.Length > 1)
                    definitions.TryAdd(i[1], i);
        }

        static bool IsType(Instruction i) => i.Op >= Op.TypeVoid && i.Op <= Op.TypeFunction;

        public uint NewId() => module.NewId();
        public Instruction Definition(uint id) => definitions[id];
        public Instruction TypeOf(uint value) => definitions[definitions[value][0]];

        /// <summary>Type of a vector's components, or of a scalar itself.</summary>
        public Instruction Scalar(Instruction type) => type.Op == Op.TypeVector ? definitions[type[1]] : type;

        /// <summary>The type with these operands after its id.</summary>
        public uint Type(Op op, params uint[] operands)
        {
            Instruction same = definitions.Values.FirstOrDefault(i => i.Op == op && i.Words.Skip(1).SequenceEqual(operands));
            return same != null ? same[0] : Add(new Instruction(op, operands.Prepend(NewId()).ToArray()))[0];
        }

        /// <summary>A bool, or a vector of as many as the type has components.</summary>
        public uint BoolFor(Instruction type) => type.Op == Op.TypeVector ? Type(Op.TypeVector, Type(Op.TypeBool), type[2]) : Type(Op.TypeBool);

        /// <summary>A number of 32 bits, in all components of a vector.</summary>
        public uint Constant(Instruction type, uint bits)
        {
            if (type.Op == Op.TypeVector)
            {
                uint component = Constant(definitions[type[1]], bits);
                return FindOrAdd(Op.ConstantComposite, type[0], Enumerable.Repeat(component, (int)type[2]).ToArray());
            }
            return FindOrAdd(Op.Constant, type[0], bits);
        }

        uint FindOrAdd(Op op, uint type, params uint[] operands)
        {
            Instruction same = definitions.Values.FirstOrDefault(i => i.Op == op && i[0] == type && i.Words.Skip(2).SequenceEqual(operands));
            return same != null ? same[1] : Add(new Instruction(op, operands.Prepend(NewId()).Prepend(type).ToArray()))[1];
        }

        /// <summary>A type, constant or variable, in front of the functions.</summary>
        public Instruction Add(Instruction global)
        {
            globals.Add(global);
            definitions[IsType(global) ? global[0] : global[1]] = global;
            return global;
        }

        public void Decorate(uint id, Decoration decoration, params uint[] operands)
            => decorations.Add(new Instruction(Op.Decorate, operands.Prepend((uint)decoration).Prepend(id).ToArray()));

        public void DecorateMember(uint type, uint member, Decoration decoration, params uint[] operands)
            => decorations.Add(new Instruction(Op.MemberDecorate, operands.Prepend((uint)decoration).Prepend(member).Prepend(type).ToArray()));

        /// <summary>The bits of a constant, all of whose components are the same; null for other values.</summary>
        public uint? ConstantBits(uint value)
        {
            if (!definitions.TryGetValue(value, out Instruction definition))
                return null;
            if (definition.Op == Op.Constant)
                return definition[2];
            if (definition.Op != Op.ConstantComposite || definition.Words.Skip(2).Distinct().Count() > 1)
                return null;
            return ConstantBits(definition[2]);
        }

        /// <summary>Puts what was added into its place in these instructions and makes them the module's.</summary>
        public void Commit(List<Instruction> instructions)
        {
            instructions.InsertRange(instructions.FindIndex(i => i.Op == Op.Function), globals);
            instructions.InsertRange(instructions.FindIndex(IsType), decorations);
            module.Instructions = instructions;
        }
    }
}
