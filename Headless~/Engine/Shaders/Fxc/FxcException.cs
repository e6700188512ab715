using System;

namespace Host.Shaders
{
    /// <summary>FXC cannot run here; the message says what is missing and how to get it. What FXC says about a shader is in
    /// <see cref="FxcResult.Messages"/>.</summary>
    sealed class FxcException : Exception
    {
        public FxcException(string message) : base(message) { }
    }
}
