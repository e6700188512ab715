using System;

namespace Host.Assets
{
    /// <summary>Types of a project that are neither its own scripts nor the host's: stand-ins for parts of Unity.</summary>
    internal interface IForeignTypes
    {
        /// <summary>A component by the name that files have for it, "Rigidbody"; null when there is none.</summary>
        Type StubComponent(string name);
        /// <summary>A script of one of Unity's packages by its GUID; null when there is none.</summary>
        Type PackageScript(string guid);
        /// <summary>Whether a type only stands for a part of Unity that is not here.</summary>
        bool IsStub(Type type);
        /// <summary>Why a script file has no class; null when it should have one.</summary>
        string WhyMissing(string assetPath);
    }
}
