using System;
using Rill;

namespace Host.Studies.Methods
{
    /// <summary>Nesterov's accelerated gradient over the Jacobi passes: t = (1 + √(1 + 4 t²))/2, β = (t − 1)/t of the next.</summary>
    sealed class NesterovJacobi : MomentumMethod
    {
        readonly string kernel;

        /// <param name="restart">Particles that a pass turns around start again.</param>
        public NesterovJacobi(bool restart) => kernel = restart ? "NesterovWithRestart" : "Nesterov";

        public override bool EndsInPackagePass => true;

        protected override void AfterPass(in StepContext step, int pass, int passes)
        {
            if (pass == passes - 1)
                return;         // the result is what a pass made, not what would begin the next
            if (pass == 0)
                RecordKernel(step, "RememberAfter", 0);
            else
                RecordKernel(step, kernel, (Time(pass) - 1) / Time(pass + 1));
        }

        static double Time(int pass) => pass == 0 ? 1 : (1 + Math.Sqrt(1 + 4 * Time(pass - 1) * Time(pass - 1))) / 2;
    }
}
