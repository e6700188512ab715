namespace Rill
{
    /// <summary>A component that refers to the stages of the features which it can use.</summary>
    interface IUsesFeatures
    {
        /// <summary>Features that a build with this component has to contain.</summary>
        FeatureSet UsedFeatures { get; }

        StageReferences StageReferences { get; }
    }
}
