namespace Rill
{
    /// <summary>Accelerates particles of a fluid; a <see cref="FluidPart"/>.</summary>
    interface IForceField
    {
        /// <summary>Whether it pulls everywhere alike, as gravity does.</summary>
        bool IsUniform { get; }

        /// <summary>Largest acceleration that it asks for, m/s².</summary>
        float MaxAcceleration { get; }

        /// <summary>Gives what it does in the next step.</summary>
        /// <param name="frame">Frame of the fluid's box.</param>
        /// <param name="spacing">m.</param>
        /// <returns>Whether it does anything.</returns>
        bool TryGetStep(in DomainFrame frame, float spacing, out FieldRegion region);
    }
}
