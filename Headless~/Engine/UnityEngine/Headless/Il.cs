using System;
using System.Collections.Generic;
using System.Reflection.Emit;

namespace UnityEngine.Headless
{
    /// <summary>Reads the instructions of a method's body (ECMA-335, III).</summary>
    internal static class Il
    {
        static readonly Dictionary<int, OpCode> OpCodesByValue = ByValue();

        /// <summary>With the operand's first four bytes; 0 where there are fewer.</summary>
        public static IEnumerable<(OpCode op, int operand)> Instructions(byte[] code)
        {
            for (int at = 0; at < code.Length;)
            {
                int value = code[at++];
                if (value == 0xFE)
                    value = value << 8 | code[at++];
                OpCode op = OpCodesByValue[value];
                int bytes = OperandBytes(op, code, at);
                yield return (op, bytes >= 4 ? BitConverter.ToInt32(code, at) : 0);
                at += bytes;
            }
        }

        static int OperandBytes(OpCode op, byte[] code, int at)
        {
            switch (op.OperandType)
            {
                case OperandType.InlineNone: return 0;
                case OperandType.ShortInlineBrTarget:
                case OperandType.ShortInlineI:
                case OperandType.ShortInlineVar: return 1;
                case OperandType.InlineVar: return 2;
                case OperandType.InlineI8:
                case OperandType.InlineR: return 8;
                case OperandType.InlineSwitch: return 4 + 4 * BitConverter.ToInt32(code, at);
                default: return 4;
            }
        }

        static Dictionary<int, OpCode> ByValue()
        {
            var all = new Dictionary<int, OpCode>();
            foreach (System.Reflection.FieldInfo field in typeof(OpCodes).GetFields())
                if (field.GetValue(null) is OpCode op)
                    all[(ushort)op.Value] = op;
            return all;
        }
    }
}
