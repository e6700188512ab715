using System;
using System.Collections.Generic;
using Host.Output;

namespace Host
{
    /// <summary>
    /// A package that was built together with the program that plays, so that nothing of it has to be compiled first. The engine by itself
    /// has none: a
    /// program for a package derives from this and sets <see cref="Current"/> before it runs a command.
    /// </summary>
    class BuiltInPackage
    {
        public static BuiltInPackage Current { get; set; } = new();

        /// <summary>Names of the assemblies with its scripts.</summary>
        public virtual IReadOnlyList<string> Assemblies => Array.Empty<string>();

        /// <summary>Names of the assemblies with its tests, and with those of its program.</summary>
        public virtual IReadOnlyList<string> Tests => Array.Empty<string>();
        public virtual IReadOnlyList<string> ProgramTests => Array.Empty<string>();

        /// <summary>A whole run of all tests that has fewer methods has lost some: all, and those that dispatch on the device.</summary>
        public virtual (int All, int Dispatching) MinTestMethods => default;

        /// <summary>Called as a session begins. What it returns is disposed of as the session ends; may be null.</summary>
        public virtual IDisposable Begin() => null;

        /// <summary>Enters a built player: assets that only the editor finds are missing.</summary>
        public virtual void EnterPlayer() { }

        /// <summary>Measurements of a run on the loaded scene.</summary>
        public virtual List<IRunProbe> Probes() => new();

        /// <summary>One number for the state of the loaded scene; null: that of all buffers.</summary>
        public virtual string StateHash() => null;
    }
}
