namespace Rill
{
    /// <summary>Component on a fluid's object that fills its box with air, and so with the smoke of its sources.</summary>
    interface IHoldsSmoke
    {
        /// <summary>Whether it does so now.</summary>
        bool IsOn { get; }
    }

    /// <summary>Heats the air over a fluid and fills it with smoke; a <see cref="FluidPart"/>.</summary>
    interface ISmokeSource
    {
        /// <summary>Gives what it does in the next step.</summary>
        /// <param name="frame">Frame of the fluid's box.</param>
        /// <param name="spacing">m.</param>
        /// <param name="airTemperature">Of the fresh air, °C.</param>
        /// <returns>Whether it does anything.</returns>
        bool TryGetStep(in DomainFrame frame, float spacing, float airTemperature, out SmokeRegion region);
    }
}
