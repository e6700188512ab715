namespace Rill
{
    /// <summary>Takes particles out of a fluid; a <see cref="FluidPart"/>.</summary>
    interface IDrain
    {
        /// <summary>Gives what it does in the next step.</summary>
        /// <param name="frame">Frame of the fluid's box.</param>
        /// <param name="spacing">m.</param>
        /// <param name="step">Duration, s.</param>
        /// <param name="from">Fraction of the frame at which the step starts.</param>
        /// <param name="to">Fraction at which it ends.</param>
        /// <returns>Whether it does anything.</returns>
        bool TryGetStep(in DomainFrame frame, float spacing, float step, float from, float to, out DrainRegion region);

        DrainRecord Save(in DomainFrame frame);

        /// <param name="tolerance">Distance within which it is where it was, d.</param>
        void Load(in DrainRecord record, in DomainFrame frame, float tolerance);
    }
}
