using System;
using NUnit.Framework;
using NUnit.Framework.Constraints;
using UnityEngine.Headless;

namespace UnityEngine.TestTools.Constraints
{
    /// <summary>Whether a delegate allocates managed memory on the calling thread.</summary>
    public class AllocatingGCMemoryConstraint : Constraint
    {
        public override string Description => "allocates GC memory";

        public override ConstraintResult ApplyTo<TActual>(TActual actual)
        {
            if (!(actual is TestDelegate code))
                throw new ArgumentException("The actual value must be a TestDelegate but was "
                    + (actual == null ? "null" : actual.GetType().Name), nameof(actual));
            return Measure(() => code());
        }

        public override ConstraintResult ApplyTo<TActual>(ActualValueDelegate<TActual> del) => Measure(() => del());

        ConstraintResult Measure(Action code)
        {
            // Compilation in the first call is not the code's allocation.
            code();
            long before = NativeWork.ScriptBytes;
            code();
            long bytes = NativeWork.ScriptBytes - before;
            return new Result(this, bytes);
        }

        sealed class Result : ConstraintResult
        {
            public Result(IConstraint constraint, long bytes) : base(constraint, bytes, bytes > 0) { }
            public override void WriteMessageTo(MessageWriter writer)
                => writer.Write($"  Expected: {Description}{Environment.NewLine}  But was:  {ActualValue} bytes{Environment.NewLine}");
        }
    }

    public static class ConstraintExtensions
    {
        public static AllocatingGCMemoryConstraint AllocatingGCMemory(this ConstraintExpression chain)
        {
            var constraint = new AllocatingGCMemoryConstraint();
            chain.Append(constraint);
            return constraint;
        }
    }

    public class Is : NUnit.Framework.Is
    {
        public static AllocatingGCMemoryConstraint AllocatingGCMemory() => new AllocatingGCMemoryConstraint();
    }
}
