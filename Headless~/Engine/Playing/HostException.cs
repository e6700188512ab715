using System;

namespace Host
{
    /// <summary>Something that the user of the command line can put right; its message stands alone.</summary>
    sealed class HostException : Exception
    {
        public HostException(string message) : base(message) { }
    }
}
