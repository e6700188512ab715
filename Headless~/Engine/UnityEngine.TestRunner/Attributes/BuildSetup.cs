using System;

namespace UnityEngine.TestTools
{
    /// <summary>Work to do once before the tests that name it run.</summary>
    public interface IPrebuildSetup { void Setup(); }

    /// <summary>Work to do once after the tests that name it ran.</summary>
    public interface IPostBuildCleanup { void Cleanup(); }

    [AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method)]
    public class PrebuildSetupAttribute : Attribute
    {
        internal readonly string TargetClass;
        public PrebuildSetupAttribute(Type targetClass) => TargetClass = targetClass.AssemblyQualifiedName;
        public PrebuildSetupAttribute(string targetClassName) => TargetClass = targetClassName;
    }

    [AttributeUsage(AttributeTargets.Assembly | AttributeTargets.Class | AttributeTargets.Method)]
    public class PostBuildCleanupAttribute : Attribute
    {
        internal readonly string TargetClass;
        public PostBuildCleanupAttribute(Type targetClass) => TargetClass = targetClass.AssemblyQualifiedName;
        public PostBuildCleanupAttribute(string targetClassName) => TargetClass = targetClassName;
    }
}
