using System;

namespace Rill.Testing
{
    /// <summary>Thrown by <see cref="FluidAssert"/>. Every test framework counts it as a failure.</summary>
    public sealed class FluidAssertionException : Exception
    {
        /// <param name="message">What was expected and what was found.</param>
        public FluidAssertionException(string message) : base(message) { }
    }
}
