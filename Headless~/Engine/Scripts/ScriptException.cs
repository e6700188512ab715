using System;

namespace Host.Scripts
{
    /// <summary>A project's scripts cannot be made into assemblies; the message names the file and the remedy.</summary>
    internal sealed class ScriptException : Exception
    {
        public ScriptException(string message) : base(message) { }
    }
}
