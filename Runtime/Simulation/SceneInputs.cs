namespace Rill
{
    /// <summary>The objects of the scene that act on a fluid.</summary>
    sealed class SceneInputs
    {
        public readonly SceneParts Parts;
        public readonly ColliderInputs Colliders;
        public readonly ConnectionInputs Connections;

        /// <summary>Sources that have thrown an exception since the fluid was enabled.</summary>
        public readonly ThrownSources Thrown = new ThrownSources();

        public SceneInputs(FluidSimulation fluid)
        {
            Parts = new SceneParts(fluid);
            Colliders = new ColliderInputs(fluid);
            Connections = new ConnectionInputs(fluid);
        }

        /// <summary>Lets all begin where they are: nothing has moved through the fluid since the last steps.</summary>
        public void ResetMotion()
        {
            Parts.ResetMotion();
            Colliders.ResetMotion();
        }

        public void Release()
        {
            Colliders.Clear();
            Connections.Release();
            Parts.Release();
        }
    }
}
