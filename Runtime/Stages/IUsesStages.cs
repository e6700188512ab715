namespace Rill
{
    /// <summary>A component that refers to the stages which it can use.</summary>
    interface IUsesStages
    {
        /// <summary>Those that a build with this component has to contain.</summary>
        StageSet UsedStages { get; }

        StageReferences StageReferences { get; }
    }
}
