using System;

namespace Host.Assets
{
    /// <summary>A project's file says something that cannot be done; the message names file, line, field and remedy.</summary>
    internal sealed class AssetException : Exception
    {
        public AssetException(string message) : base(message) { }
        public AssetException(string message, Exception cause) : base(message, cause) { }
    }
}
