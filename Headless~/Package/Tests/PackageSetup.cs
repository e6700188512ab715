using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>NUnit looks for a set-up in each assembly: this is the engine's, for tests of the package.</summary>
    [SetUpFixture]
    public sealed class PackageSetup : HostSetup
    {
    }
}
