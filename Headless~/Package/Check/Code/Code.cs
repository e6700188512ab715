using System.Collections.Generic;
using System.Reflection.Emit;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>Lists what a method's body stores to and calls.</summary>
    static class Code
    {
        /// <summary>Metadata tokens of the static fields that the code stores to.</summary>
        public static IEnumerable<int> FieldsStored(byte[] code)
        {
            foreach ((OpCode op, int operand) in Il.Instructions(code))
                if (op == OpCodes.Stsfld)
                    yield return operand;
        }

        public static IEnumerable<EntityHandle> MethodsCalled(byte[] code)
        {
            foreach ((OpCode op, int operand) in Il.Instructions(code))
                if (op.OperandType == OperandType.InlineMethod)
                    yield return (EntityHandle)MetadataTokens.Handle(operand);
        }
    }
}
