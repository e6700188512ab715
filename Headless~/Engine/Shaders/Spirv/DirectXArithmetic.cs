using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>
    /// Adds Direct3D's results where Vulkan leaves them open (Direct3D 11.3 functional specification, 22.10 to 22.13):
    /// a shift takes the low five bits of its amount; integers divided by zero give all ones; a float that an integer cannot
    /// hold becomes the nearest one that it can, and NaN becomes 0; the minimum and maximum with a NaN are the other number.
    /// </summary>
    sealed class DirectXArithmetic
    {
        const uint FMin = 37, FMax = 40, FClamp = 43, NMin = 79, NMax = 80, NClamp = 81;    // GLSL.std.450
        const uint Ones = 0xFFFFFFFF, MaxInt = 0x7FFFFFFF, MinInt = 0x80000000;

        readonly SpirvEditor editor;
        readonly uint extended;     // GLSL.std.450; 0 = not imported
        readonly List<Instruction> output = new List<Instruction>();

        DirectXArithmetic(SpirvModule module)
        {
            editor = new SpirvEditor(module);
            extended = module.Instructions.FirstOrDefault(i => i.Op == Op.ExtInstImport && i.Text(1) == "GLSL.std.450")?[0] ?? 0;
        }

        public static void Apply(SpirvModule module)
        {
            var rewriter = new DirectXArithmetic(module);
            foreach (Instruction i in module.Instructions)
                rewriter.Rewrite(i);
            rewriter.editor.Commit(rewriter.output);
        }

        void Rewrite(Instruction i)
        {
            switch (i.Op)
            {
                case Op.ShiftLeftLogical:
                case Op.ShiftRightLogical:
                case Op.ShiftRightArithmetic:
                    if (IsWord(i[0]))
                        MaskShift(i);
                    break;
                case Op.UDiv:
                case Op.UMod:
                    if (IsWord(i[0]) && (editor.ConstantBits(i[3]) ?? 0) == 0)
                    {
                        DivideUnsigned(i);
                        return;
                    }
                    break;
                case Op.SDiv:
                case Op.SRem:
                    if (IsWord(i[0]) && (editor.ConstantBits(i[3]) ?? 0) is 0 or Ones)
                    {
                        DivideSigned(i);
                        return;
                    }
                    break;
                case Op.ConvertFToU:
                case Op.ConvertFToS:
                    if (IsWord(i[0]) && IsWord(editor.TypeOf(i[2])[0]))
                    {
                        Saturate(i);
                        return;
                    }
                    break;
                case Op.ExtInst when i[2] == extended:
                    i.Words[3] = i[3] == FMin ? NMin : i[3] == FMax ? NMax : i[3] == FClamp ? NClamp : i[3];
                    break;
            }
            output.Add(i);
        }

        bool IsWord(uint type) => editor.Scalar(editor.Definition(type))[1] == 32;

        uint Emit(Op op, uint type, params uint[] operands)
        {
            uint id = editor.NewId();
            output.Add(new Instruction(op, operands.Prepend(id).Prepend(type).ToArray()));
            return id;
        }

        void MaskShift(Instruction shift)
        {
            const uint most = 31;
            if ((editor.ConstantBits(shift[3]) ?? Ones) <= most)
                return;
            Instruction type = editor.TypeOf(shift[3]);
            shift.Words[3] = Emit(Op.BitwiseAnd, type[0], shift[3], editor.Constant(type, most));
        }

        // The divisor is kept from zero, since no more than the result is undefined only where a driver is kind.
        void DivideUnsigned(Instruction division)
        {
            Instruction type = editor.Definition(division[0]);
            uint isZero = Emit(Op.IEqual, editor.BoolFor(type), division[3], editor.Constant(type, 0));
            uint divisor = Emit(Op.Select, type[0], isZero, editor.Constant(type, 1), division[3]);
            uint result = Emit(division.Op, type[0], division[2], divisor);
            output.Add(new Instruction(Op.Select, type[0], division[1], isZero, editor.Constant(type, Ones), result));
        }

        // FXC divides absolute values by udiv and then negates: so zero gives -1, or 1 where the quotient (for a remainder the
        // dividend) is negative. The smallest integer by -1 is itself.
        void DivideSigned(Instruction division)
        {
            Instruction type = editor.Definition(division[0]);
            uint condition = editor.BoolFor(type), zero = editor.Constant(type, 0), one = editor.Constant(type, 1),
                minusOne = editor.Constant(type, Ones);
            uint isZero = Emit(Op.IEqual, condition, division[3], zero), isMinusOne = Emit(Op.IEqual, condition, division[3], minusOne);
            uint divisor = Emit(Op.Select, type[0], Emit(Op.LogicalOr, condition, isZero, isMinusOne), one, division[3]);
            uint result = Emit(division.Op, type[0], division[2], divisor);
            if (division.Op == Op.SDiv)
                result = Emit(Op.Select, type[0], isMinusOne, Emit(Op.SNegate, type[0], result), result);
            uint byZero = Emit(Op.Select, type[0], Emit(Op.SLessThan, condition, division[2], zero), one, minusOne);
            output.Add(new Instruction(Op.Select, type[0], division[1], isZero, byZero, result));
        }

        void Saturate(Instruction conversion)
        {
            bool signed = conversion.Op == Op.ConvertFToS;
            float above = signed ? 2147483648f : 4294967296f, below = signed ? -2147483648f : 0;
            Instruction type = editor.Definition(conversion[0]), real = editor.TypeOf(conversion[2]);
            uint condition = editor.BoolFor(type), value = conversion[2];
            uint isAbove = Emit(Op.FOrdGreaterThanEqual, condition, value, editor.Constant(real, BitConverter.SingleToUInt32Bits(above)));
            uint isBelow = Emit(Op.FOrdLessThan, condition, value, editor.Constant(real, BitConverter.SingleToUInt32Bits(below)));
            uint isNaN = Emit(Op.FUnordNotEqual, condition, value, value);
            uint isOut = Emit(Op.LogicalOr, condition, Emit(Op.LogicalOr, condition, isAbove, isBelow), isNaN);
            uint inside = Emit(Op.Select, real[0], isOut, editor.Constant(real, 0), value);
            uint result = Emit(conversion.Op, type[0], inside);
            result = Emit(Op.Select, type[0], isAbove, editor.Constant(type, signed ? MaxInt : Ones), result);
            output.Add(new Instruction(Op.Select, type[0], conversion[1], isBelow, editor.Constant(type, signed ? MinInt : 0), result));
        }
    }
}
