using Rill;

namespace Host.Studies.Methods
{
    /// <summary>
    /// The Chebyshev semi-iterative method for Position Based Dynamics (Wang 2015): ω is 1 in the first passes, then
    /// 2/(2 − ρ²), then 4/(4 − ρ² ω). The relaxation of a pass is the paper's γ.
    /// </summary>
    sealed class ChebyshevJacobi : MomentumMethod
    {
        readonly double radius;
        readonly int start;

        /// <param name="radius">Estimate ρ of the iteration's spectral radius, below 1.</param>
        /// <param name="start">Passes S before the acceleration, at least 1.</param>
        public ChebyshevJacobi(double radius, int start)
        {
            this.radius = radius;
            this.start = start;
        }

        protected override void AfterPass(in StepContext step, int pass, int passes)
        {
            if (pass == start - 1)
                RecordKernel(step, "Remember", 1);
            else if (pass >= start)
                RecordKernel(step, "Chebyshev", Weight(pass));
        }

        /// <summary>ω of a pass, the first being 0.</summary>
        public double Weight(int pass) => pass < start ? 1 : pass == start ? 2 / (2 - radius * radius) : 4 / (4 - radius * radius * Weight(pass - 1));
    }
}
