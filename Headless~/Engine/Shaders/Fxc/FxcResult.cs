using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    /// <summary>An error or a warning of FXC.</summary>
    sealed class FxcMessage
    {
        public bool IsError;
        /// <summary>"X3206"; empty for messages without one.</summary>
        public string Number = "";
        /// <summary>In the file that was written, be it an include.</summary>
        public SourceLine Where;
        public string Text;

        public override string ToString()
            => $"{Where.File}({Where.Line}): {(IsError ? "error" : "warning")}{(Number.Length > 0 ? " " + Number : "")}: {Text}";
    }

    /// <summary>Result of FXC for a request.</summary>
    sealed class FxcResult
    {
        /// <summary>Null when it failed.</summary>
        public byte[] Dxbc;
        /// <summary>Errors and warnings, each once, in FXC's order.</summary>
        public IReadOnlyList<FxcMessage> Messages = Array.Empty<FxcMessage>();

        public bool Success => Dxbc != null;
        public IEnumerable<FxcMessage> Errors => Messages.Where(m => m.IsError);
        public IEnumerable<FxcMessage> Warnings => Messages.Where(m => !m.IsError);
    }
}
