using System.Collections.Generic;

namespace Host.Shaders
{
    /// <summary>Look-ups over a module: types, constants and variables by id, names, decorations.</summary>
    sealed class SpirvTypes
    {
        readonly Dictionary<uint, Instruction> definitions = new Dictionary<uint, Instruction>();
        readonly Dictionary<uint, string> names = new Dictionary<uint, string>();
        readonly Dictionary<(uint, uint), string> memberNames = new Dictionary<(uint, uint), string>();
        readonly Dictionary<(uint, Decoration), Instruction> decorations = new Dictionary<(uint, Decoration), Instruction>();
        readonly Dictionary<(uint, uint, Decoration), Instruction> memberDecorations = new Dictionary<(uint, uint, Decoration), Instruction>();

        public SpirvTypes(SpirvModule module)
        {
            foreach (Instruction i in module.Instructions)
                switch (i.Op)
                {
                    case Op.Name: names[i[0]] = i.Text(1); break;
                    case Op.MemberName: memberNames[(i[0], i[1])] = i.Text(2); break;
                    case Op.Decorate:
                    case Op.DecorateId:
                    case Op.DecorateString: decorations[(i[0], (Decoration)i[1])] = i; break;
                    case Op.MemberDecorate: memberDecorations[(i[0], i[1], (Decoration)i[2])] = i; break;
                    case Op.Undef:
                    case Op.Variable: definitions[i[1]] = i; break;
                    case Op.Function: return;
                    default:
                        if (i.Op >= Op.TypeVoid && i.Op <= Op.TypePointer)
                            definitions[i[0]] = i;
                        else if (i.Op >= Op.ConstantTrue && i.Op <= Op.SpecConstantOp)
                            definitions[i[1]] = i;
                        break;
                }
        }

        public Instruction this[uint id] => definitions[id];
        public bool Has(uint id) => definitions.ContainsKey(id);
        public string Name(uint id) => names.TryGetValue(id, out string name) ? name : "";
        public string MemberName(uint type, int member) => memberNames.TryGetValue((type, (uint)member), out string name) ? name : "";

        /// <summary>Null when the id is not decorated so. The decoration's own operands start at word 2.</summary>
        public Instruction Decorated(uint id, Decoration decoration) => decorations.TryGetValue((id, decoration), out Instruction i) ? i : null;
        /// <summary>Null when the member is not decorated so. The decoration's own operands start at word 3.</summary>
        public Instruction Decorated(uint type, int member, Decoration decoration)
            => memberDecorations.TryGetValue((type, (uint)member, decoration), out Instruction i) ? i : null;

        public int Constant(uint id) => (int)definitions[id][2];
        /// <summary>The type that a variable's pointer points to.</summary>
        public Instruction Pointee(Instruction variable) => definitions[definitions[variable[0]][2]];
        public int ScalarBytes(Instruction type) => type.Op == Op.TypeBool ? 4 : (int)type[1] / 8;
    }
}
